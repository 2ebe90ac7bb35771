# Builds and installs the ParaView plugin, whose folder is excluded from both.
add_custom_target(smPlugin ALL DEPENDS SolidMoments)
if (TARGET smParaViewPanel)
  add_dependencies(smPlugin smParaViewPanel)
  install(TARGETS smParaViewPanel LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/SolidMoments" COMPONENT Plugin)
endif ()
set(solidmoments_plugin_destination "${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}")
install(TARGETS SolidMoments LIBRARY DESTINATION "${solidmoments_plugin_destination}/SolidMoments" COMPONENT Plugin)
install(FILES "${CMAKE_BINARY_DIR}/${solidmoments_plugin_destination}/solidmoments.xml"
  DESTINATION "${solidmoments_plugin_destination}" COMPONENT Plugin)
# A list of plugins makes ParaView load it, in the Debian package only. Debian 13's ParaView names, in its
# paraview.conf, a list of plugins that other packages bring; that of Debian 12 has no such file, and reads
# one next to its programs.
get_filename_component(libraries "${ParaView_DIR}/../.." ABSOLUTE)
set(list)
if (EXISTS "${libraries}/${PARAVIEW_PLUGIN_SUBDIR}/../paraview.conf")
  file(STRINGS "${libraries}/${PARAVIEW_PLUGIN_SUBDIR}/../paraview.conf" list REGEX "^/" LIMIT_COUNT 1)
endif ()
if (list)
  file(RELATIVE_PATH list "${CMAKE_INSTALL_PREFIX}" "${list}")
else ()
  set(list "${solidmoments_plugin_destination}/solidmoments.xml")
  file(WRITE "${CMAKE_BINARY_DIR}/CMakeFiles/paraview.conf" "${CMAKE_INSTALL_PREFIX}/${list}\n")
  install(FILES "${CMAKE_BINARY_DIR}/CMakeFiles/paraview.conf" DESTINATION "${CMAKE_INSTALL_BINDIR}"
    COMPONENT Plugin EXCLUDE_FROM_ALL)
endif ()
file(WRITE "${CMAKE_BINARY_DIR}/CMakeFiles/plugins.xml" "<?xml version=\"1.0\"?>
<Plugins>
  <Plugin name=\"SolidMoments\" auto_load=\"1\"
    filename=\"${CMAKE_INSTALL_PREFIX}/${solidmoments_plugin_destination}/SolidMoments/SolidMoments.so\"/>
</Plugins>
")
get_filename_component(folder "${list}" DIRECTORY)
get_filename_component(name "${list}" NAME)
install(FILES "${CMAKE_BINARY_DIR}/CMakeFiles/plugins.xml" DESTINATION "${folder}" RENAME "${name}"
  COMPONENT Plugin EXCLUDE_FROM_ALL)
