# Builds and installs the ParaView plugin, whose folder is excluded from both.
add_custom_target(smPlugin ALL DEPENDS SolidMoments)
set(solidmoments_plugin_destination "${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}")
install(TARGETS SolidMoments LIBRARY DESTINATION "${solidmoments_plugin_destination}/SolidMoments" COMPONENT Plugin)
install(FILES "${CMAKE_BINARY_DIR}/${solidmoments_plugin_destination}/solidmoments.xml"
  DESTINATION "${solidmoments_plugin_destination}" COMPONENT Plugin)
# ParaView reads the names of further lists of plugins from this file beside its programs. Debian's ParaView has none: only the package
# brings it.
file(RELATIVE_PATH solidmoments_plugin_list
  "${CMAKE_INSTALL_FULL_BINDIR}" "${CMAKE_INSTALL_PREFIX}/${solidmoments_plugin_destination}/solidmoments.xml")
file(WRITE "${CMAKE_BINARY_DIR}/CMakeFiles/paraview.conf" "${solidmoments_plugin_list}\n")
install(FILES "${CMAKE_BINARY_DIR}/CMakeFiles/paraview.conf" DESTINATION "${CMAKE_INSTALL_BINDIR}"
  COMPONENT Plugin EXCLUDE_FROM_ALL)
