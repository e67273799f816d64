# What find_package(vtkRTWShadows) finds, installed.
include(CMakePackageConfigHelpers)

set(rtw_installed_python)
if (RTW_WRAP_PYTHON)
  set(rtw_installed_python "${RTW_PYTHON_DESTINATION}")
endif ()
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/vtkRTWShadowsConfig.cmake.in"
  "${CMAKE_BINARY_DIR}/${rtw_cmake_destination}/vtkRTWShadowsConfig.cmake"
  INSTALL_DESTINATION "${rtw_cmake_destination}"
  PATH_VARS rtw_headers_destination)
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${rtw_cmake_destination}/vtkRTWShadowsConfigVersion.cmake"
  VERSION       "${PROJECT_VERSION}"
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${CMAKE_BINARY_DIR}/${rtw_cmake_destination}/vtkRTWShadowsConfig.cmake"
    "${CMAKE_BINARY_DIR}/${rtw_cmake_destination}/vtkRTWShadowsConfigVersion.cmake"
  DESTINATION "${rtw_cmake_destination}"
  COMPONENT   development)
install(FILES LICENSE README.md CHANGELOG.md
  DESTINATION "${CMAKE_INSTALL_DOCDIR}")
