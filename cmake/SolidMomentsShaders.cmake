# solidmoments_encode_shaders(<library> <file.glsl>...)
#
# Embeds each file as a C string of the file's name: glsl/smReduceCS.glsl becomes `extern const char*
# smReduceCS` in smReduceCS.h, exported from <library> (a vtk.module's LIBRARY_NAME) so that other modules can
# use the text. Sets shader_headers and shader_sources for PRIVATE_HEADERS and SOURCES of
# vtk_module_add_module.
function(solidmoments_encode_shaders library)
  string(TOUPPER "${library}_EXPORT" export_symbol)
  set(headers)
  set(sources)
  foreach (file IN LISTS ARGN)
    vtk_encode_string(
      INPUT         "${file}"
      EXPORT_SYMBOL "${export_symbol}"
      EXPORT_HEADER "${library}Module.h"
      HEADER_OUTPUT header
      SOURCE_OUTPUT source)
    list(APPEND headers "${header}")
    list(APPEND sources "${source}")
  endforeach ()
  set(shader_headers "${headers}" PARENT_SCOPE)
  set(shader_sources "${sources}" PARENT_SCOPE)
endfunction ()
