# Finds every library by its usual package. A missing required one ends the configuration
# with one line that names the package to install.

file(STRINGS ${CMAKE_SOURCE_DIR}/cmake/packages.txt timestep_packages REGEX "^[a-z]")

function(timestep_missing what)
  foreach(line ${timestep_packages})
    string(REGEX REPLACE " +" ";" row "${line}")
    list(GET row 0 name)
    if(name STREQUAL what)
      list(GET row 2 apt)
      list(GET row 3 dnf)
      list(GET row 4 pacman)
      list(GET row 5 brew)
      message(FATAL_ERROR "Timestep needs ${what}; install it as ${apt} (apt), ${dnf} (dnf), "
                          "${pacman} (pacman) or ${brew} (brew), or run ./timestep tour")
    endif()
  endforeach()
endfunction()

function(timestep_find_header_library what header)
  find_path(${what}_include ${header} ${ARGN})
  if(NOT ${what}_include)
    timestep_missing(${what})
  endif()
  add_library(${what}_headers INTERFACE)
  target_include_directories(${what}_headers SYSTEM INTERFACE ${${what}_include})
endfunction()

# Header-only, found by the header itself: their CMake packages differ between systems
timestep_find_header_library(glm glm/glm.hpp)
timestep_find_header_library(cli11 CLI/CLI.hpp)
timestep_find_header_library(json nlohmann/json.hpp)
timestep_find_header_library(stb stb_image_write.h PATH_SUFFIXES stb)

find_package(fmt QUIET)
if(NOT fmt_FOUND)
  timestep_missing(fmt)
endif()

find_package(glfw3 3.3 QUIET)
if(NOT glfw3_FOUND)
  timestep_missing(glfw)
endif()

find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(epoxy QUIET IMPORTED_TARGET epoxy)
endif()
if(NOT TARGET PkgConfig::epoxy)
  find_path(epoxy_include epoxy/gl.h)
  find_library(epoxy_library epoxy)
  if(NOT epoxy_include OR NOT epoxy_library)
    timestep_missing(epoxy)
  endif()
  add_library(PkgConfig::epoxy INTERFACE IMPORTED)
  target_include_directories(PkgConfig::epoxy INTERFACE ${epoxy_include})
  target_link_libraries(PkgConfig::epoxy INTERFACE ${epoxy_library})
endif()

# Dear ImGui with its OpenGL 3 and GLFW backends, as distributions ship it
find_path(imgui_include imgui.h PATH_SUFFIXES imgui)
find_library(imgui_library imgui)
if(NOT imgui_include OR NOT imgui_library)
  timestep_missing(imgui)
endif()
add_library(imgui INTERFACE)
target_include_directories(imgui SYSTEM INTERFACE ${imgui_include} ${imgui_include}/backends)
target_link_libraries(imgui INTERFACE ${imgui_library} glfw ${CMAKE_DL_LIBS})

# libccd, one of the backends of chapter 4
if(PkgConfig_FOUND)
  pkg_check_modules(ccd QUIET IMPORTED_TARGET ccd)
endif()
add_library(libccd INTERFACE)
if(TARGET PkgConfig::ccd)
  target_link_libraries(libccd INTERFACE PkgConfig::ccd)
else()
  find_path(ccd_include ccd/ccd.h)
  find_library(ccd_library ccd)
  if(NOT ccd_include OR NOT ccd_library)
    timestep_missing(ccd)
  endif()
  target_include_directories(libccd SYSTEM INTERFACE ${ccd_include})
  target_link_libraries(libccd INTERFACE ${ccd_library})
endif()

find_package(Catch2 QUIET)
if(NOT Catch2_FOUND)
  timestep_missing(catch2)
endif()

# Optional: what needs them says so when it is asked for
find_package(assimp QUIET)
message(STATUS "assimp, for mesh files: ${assimp_FOUND}")

# Optional: libraries that the tests of chapter 4 compare it with
find_path(qhull_include libqhull_r/libqhull_r.h)
find_library(qhull_library qhull_r)
if(NOT qhull_include OR NOT qhull_library)
  set(qhull_library "")
endif()
if(PkgConfig_FOUND)
  pkg_check_modules(fcl QUIET IMPORTED_TARGET fcl)
endif()
if(TARGET PkgConfig::fcl)
  set_target_properties(PkgConfig::fcl PROPERTIES INTERFACE_COMPILE_OPTIONS "")  # C++11
endif()
message(STATUS "Qhull, for tests: ${qhull_library}, FCL: ${fcl_FOUND}")
