# Completion of solidmoments for bash: values of options that choose among words, options as --help has them, files.
_solidmoments()
{
  local word=${COMP_WORDS[COMP_CWORD]} words=
  case ${COMP_WORDS[COMP_CWORD - 1]} in
    --unit) words="mm cm m um inch ft file" ;;
    --input-unit) words="mm cm m um inch ft" ;;
    --backend) words="auto opengl x egl cpu" ;;
    --scheme) words="adaptive midpoint gauss2 gauss3" ;;
    --deviation) words="bounded sampled" ;;
    --stability | --up) words="x y z -x -y -z" ;;
    --about) words="origin" ;;
    --robot) words="urdf sdf mjcf" ;;
    --collision) words="none hull" ;;
    --hidden) words="count skip only" ;;
    --repair) words="needed always never" ;;
    --require) words="stable mass validation" ;;
    --fail-on) words="open tolerance-not-met suspect not-computed empty none" ;;
    *)
      if [[ $word == -* ]]
      then
        words=$("${COMP_WORDS[0]}" --help 2>/dev/null | grep -oE -- '(^|[ ,])--[a-z-]+' | tr -d ' ,')
      fi
      ;;
  esac
  if [[ -n $words ]]
  then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  fi
}
complete -o filenames -F _solidmoments solidmoments
