# What the program links, all of it from Debian 12 packages: see packages.txt. Installed beside
# sidestepConfig.cmake, too, for programs that link our libraries need the same.
find_package(mujoco REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(meshoptimizer REQUIRED)
find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(EIGEN3 REQUIRED IMPORTED_TARGET eigen3)
pkg_check_modules(ASSIMP REQUIRED IMPORTED_TARGET assimp)
pkg_check_modules(IPOPT REQUIRED IMPORTED_TARGET ipopt)
pkg_check_modules(OSMESA REQUIRED IMPORTED_TARGET osmesa)
pkg_check_modules(MATIO REQUIRED IMPORTED_TARGET matio)
pkg_check_modules(URDFDOM REQUIRED IMPORTED_TARGET urdfdom tinyxml)

# Ipopt's pkg-config adds /usr/include/coin; mark it as a system path so that its warnings stay out.
foreach(lib IPOPT EIGEN3 OSMESA URDFDOM)
  get_target_property(dirs PkgConfig::${lib} INTERFACE_INCLUDE_DIRECTORIES)
  if(dirs)
    set_target_properties(PkgConfig::${lib} PROPERTIES
                          INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${dirs}")
  endif()
endforeach()

# Debian's exported MuJoCo target names an include folder that no package brings.
set_target_properties(mujoco::mujoco PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "")
