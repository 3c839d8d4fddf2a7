# The targets, for libraries in MESHCCD_FROM (their DLL on Windows in MESHCCD_FROM too, or in
# MESHCCD_FROM_DLL) and the header in MESHCCD_INCLUDE.
if(NOT TARGET meshccd::meshccd)
  add_library(meshccd::meshccd SHARED IMPORTED GLOBAL)
  add_library(meshccd::static STATIC IMPORTED GLOBAL)
  foreach(target meshccd::meshccd meshccd::static)
    set_target_properties(${target} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${MESHCCD_INCLUDE}")
  endforeach()

  if(WIN32)
    if(NOT MESHCCD_FROM_DLL)
      set(MESHCCD_FROM_DLL "${MESHCCD_FROM}")
    endif()
    set_target_properties(meshccd::meshccd PROPERTIES
      IMPORTED_LOCATION "${MESHCCD_FROM_DLL}/meshccd.dll"
      IMPORTED_IMPLIB "${MESHCCD_FROM}/meshccd.dll.lib")
    set_target_properties(meshccd::static PROPERTIES
      IMPORTED_LOCATION "${MESHCCD_FROM}/meshccd.lib")
    # What `rustc --print native-static-libs` names.
    set_target_properties(meshccd::static PROPERTIES INTERFACE_LINK_LIBRARIES
      "kernel32;ntdll;userenv;ws2_32;dbghelp;advapi32;user32;gdi32;ole32;oleaut32;opengl32;d3dcompiler;dxgi;d3d12;propsys;runtimeobject")
  else()
    set_target_properties(meshccd::meshccd PROPERTIES
      IMPORTED_LOCATION "${MESHCCD_FROM}/libmeshccd${CMAKE_SHARED_LIBRARY_SUFFIX}")
    set_target_properties(meshccd::static PROPERTIES
      IMPORTED_LOCATION "${MESHCCD_FROM}/libmeshccd.a")
    if(APPLE)
      set_target_properties(meshccd::static PROPERTIES INTERFACE_LINK_LIBRARIES
        "-framework CoreFoundation;-framework CoreGraphics;-framework Foundation;-framework Metal;-framework QuartzCore;objc;iconv;System;m")
    else()
      set(THREADS_PREFER_PTHREAD_FLAG TRUE)
      find_package(Threads REQUIRED)
      set_target_properties(meshccd::static PROPERTIES INTERFACE_LINK_LIBRARIES
        "Threads::Threads;${CMAKE_DL_LIBS};gcc_s;rt;m")
    endif()
  endif()
endif()
