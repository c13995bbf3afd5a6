# `cpack -G DEB` in the release build's folder makes two Debian packages: `sidestep`, the program and
# its data, and `sidestep-dev`, headers and libraries for controllers of one's own. They are apart
# because the second needs a dozen -dev packages that who only runs scenarios does not.
set(CPACK_PACKAGE_NAME sidestep)
set(CPACK_PACKAGE_VENDOR "Sidestep")
set(CPACK_PACKAGE_CONTACT "The Sidestep authors <sidestep@localhost>")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL sidestep sidestep-dev)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_SIDESTEP_PACKAGE_NAME sidestep)
set(CPACK_DEBIAN_SIDESTEP_PACKAGE_SHLIBDEPS ON)
# Without them, `run --no-video --no-plots` works.
set(CPACK_DEBIAN_SIDESTEP_PACKAGE_RECOMMENDS "ffmpeg, gnuplot-nox")
set(CPACK_DEBIAN_SIDESTEP-DEV_PACKAGE_NAME sidestep-dev)
set(CPACK_DEBIAN_SIDESTEP-DEV_PACKAGE_SECTION libdevel)
# The -dev packages of packages.txt that our headers include or our libraries link.
set(CPACK_DEBIAN_SIDESTEP-DEV_PACKAGE_DEPENDS
    "sidestep (= ${PROJECT_VERSION}), pkg-config, libmujoco-dev, libosmesa6-dev, libeigen3-dev, \
libassimp-dev, libmatio-dev, libmeshoptimizer-dev, coinor-libipopt-dev, libblas-dev, liblapack-dev, liburdfdom-dev, libyaml-cpp-dev, nlohmann-json3-dev")
set(CPACK_COMPONENT_SIDESTEP_DESCRIPTION
    "Pushes simulated legged robots and tells whether they catch themselves: MuJoCo in the loop, an
online centroidal MPC that moves the next footstep, videos without a display, plots and a verdict.")
set(CPACK_COMPONENT_SIDESTEP-DEV_DESCRIPTION
    "Headers and static libraries of Sidestep, for programs that bring their own controller.")
include(CPack)

# A citation names the version that it cites.
file(STRINGS ${PROJECT_SOURCE_DIR}/CITATION.cff cited REGEX "^version: ")
if(NOT cited STREQUAL "version: ${PROJECT_VERSION}")
  message(FATAL_ERROR "CITATION.cff says '${cited}', CMakeLists.txt ${PROJECT_VERSION}")
endif()
