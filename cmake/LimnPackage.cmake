# What a desktop wants to know of the program (component program), and `cpack -G DEB`. Shaders and
# meshes are in the program itself, so that it runs from wherever it lies.
set(data ${PROJECT_SOURCE_DIR}/packaging)
install(FILES ${data}/org.limn.Limn.desktop
  DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT program)
install(FILES ${data}/org.limn.Limn.metainfo.xml
  DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT program)
install(FILES ${data}/limn-mime.xml
  DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME limn.xml COMPONENT program)
install(FILES ${data}/limn.svg
  DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT program)
foreach(size 48 128 256)
  install(FILES ${data}/limn-${size}.png
    DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/${size}x${size}/apps RENAME limn.png
    COMPONENT program)
endforeach()

# Debian wants these compressed, without the time in them, and the licence in its own form.
set(out ${PROJECT_BINARY_DIR}/packaging)
file(READ ${PROJECT_SOURCE_DIR}/LICENSE licence)
string(REGEX REPLACE "^[^\n]*\n\n[^\n]*\n\n" "" licence "${licence}")
string(STRIP "${licence}" licence)
string(REPLACE "\n\n" "\n.\n" licence "${licence}")
string(REPLACE "\n" "\n " licence "${licence}")
file(READ ${data}/copyright.in head)
file(WRITE ${out}/copyright "${head} ${licence}\n")
set(compressed)
foreach(pair limn.1=limn.1.gz debian-changelog=changelog.gz)
  string(REPLACE "=" ";" pair ${pair})
  list(GET pair 0 from)
  list(GET pair 1 to)
  add_custom_command(OUTPUT ${out}/${to}
    COMMAND gzip -9nc ${data}/${from} > ${out}/${to}
    DEPENDS ${data}/${from} VERBATIM)
  list(APPEND compressed ${out}/${to})
endforeach()
add_custom_target(limn_packaging ALL DEPENDS ${compressed})
install(FILES ${out}/limn.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${out}/copyright ${out}/changelog.gz
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/limn COMPONENT program)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME limn)
set(CPACK_PACKAGE_CONTACT "The Limn authors <limn@users.noreply.github.com>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "adaptive mesh subdivision by painting")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
  "Limn opens a polygon mesh, lets its faces be painted with how often they are
to be subdivided, and makes a mesh without cracks in which every vertex lies
where uniform Catmull-Clark subdivision would have put it.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL program)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
  GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Loaded when they are needed: OpenGL through GLFW, and EGL or OSMesa without a display.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgl1, libegl1, fonts-inter")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libosmesa6")
include(CPack)
