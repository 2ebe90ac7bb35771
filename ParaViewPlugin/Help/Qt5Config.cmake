# Stands in for Qt's package, which distributions' ParaView packages do not bring: ParaView's
# paraview_client_generate_help() needs nothing of it but the program that compiles help.
if (NOT TARGET Qt5::qhelpgenerator)
  add_executable(Qt5::qhelpgenerator IMPORTED)
  set_target_properties(Qt5::qhelpgenerator PROPERTIES IMPORTED_LOCATION "${SOLIDMOMENTS_QHELPGENERATOR}")
endif ()
set(Qt5Help_FOUND TRUE)
