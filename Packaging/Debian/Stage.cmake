# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# CPack runs this on what it has installed for the packages, before it packs them: what Debian wants otherwise than an
# installation by hand below any prefix. A folder a package: ${CPACK_TEMPORARY_DIRECTORY}/COMPONENT/usr.

cmake_policy(VERSION 3.22)

# The date of the packages' changelog is that of the sources', so that the same sources give the same bytes.
if (NOT DEFINED ENV{SOURCE_DATE_EPOCH})
  file(TIMESTAMP "${CPACK_STIPPLE_SOURCE}/CHANGELOG.md" date "%s" UTC)
  set(ENV{SOURCE_DATE_EPOCH} "${date}")
endif ()
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)

function (stipple_must)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status ERROR_VARIABLE text OUTPUT_QUIET)
  if (status)
    message(FATAL_ERROR "${ARGN}: ${status}\n${text}")
  endif ()
endfunction ()

function (stipple_move from to)
  if (EXISTS "${from}")
    get_filename_component(folder "${to}" DIRECTORY)
    file(MAKE_DIRECTORY "${folder}")
    file(RENAME "${from}" "${to}")
  endif ()
endfunction ()

foreach (component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER "${component}" id)
  set(package "${CPACK_DEBIAN_${id}_PACKAGE_NAME}")
  set(root "${CPACK_TEMPORARY_DIRECTORY}/${component}/usr")
  set(doc "${root}/share/doc/${package}")

  # Python's packages are for any python3, completions of packages have a folder of their own.
  file(GLOB versioned "${root}/lib/python3.*/dist-packages")
  if (versioned)
    stipple_move("${versioned}" "${root}/lib/python3/dist-packages")
    get_filename_component(versioned "${versioned}" DIRECTORY)
    file(REMOVE_RECURSE "${versioned}")
  endif ()
  stipple_move("${root}/share/zsh/site-functions" "${root}/share/zsh/vendor-completions")

  # Below /usr everything is found without a path to look in.
  file(GLOB_RECURSE binaries "${root}/bin/*" "${root}/lib/*.so" "${root}/lib/*.so.*")
  foreach (binary IN LISTS binaries)
    if (NOT IS_SYMLINK "${binary}")
      file(RPATH_REMOVE FILE "${binary}")
    endif ()
  endforeach ()
  file(GLOB_RECURSE libraries "${root}/lib/*.so" "${root}/lib/*.so.*")
  foreach (library IN LISTS libraries)
    if (NOT IS_SYMLINK "${library}")
      file(CHMOD "${library}" PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
    endif ()
  endforeach ()

  # The documents of every package.
  file(REMOVE_RECURSE "${root}/share/licenses")
  if (component STREQUAL "doc")
    stipple_move("${root}/${CPACK_STIPPLE_DOCDIR}" "${root}/share/doc/stipple-doc")
    stipple_move("${doc}/Documentation/Examples" "${doc}/examples")
    if (CPACK_STIPPLE_DOXYGEN)
      set(pages "${CPACK_TEMPORARY_DIRECTORY}/doxygen")
      file(REMOVE_RECURSE "${pages}")
      file(MAKE_DIRECTORY "${pages}")
      file(WRITE "${pages}/Doxyfile"
        "@INCLUDE = ${CPACK_STIPPLE_SOURCE}/Documentation/Doxyfile\nOUTPUT_DIRECTORY = ${pages}\n")
      execute_process(COMMAND "${CPACK_STIPPLE_DOXYGEN}" "${pages}/Doxyfile"
        WORKING_DIRECTORY "${CPACK_STIPPLE_SOURCE}" RESULT_VARIABLE status ERROR_VARIABLE text OUTPUT_QUIET)
      if (status)
        message(FATAL_ERROR "doxygen: ${text}")
      endif ()
      file(RENAME "${pages}/html" "${doc}/html")
      file(GLOB leftovers "${doc}/html/*.md5" "${doc}/html/*.map")
      if (leftovers)
        file(REMOVE ${leftovers})
      endif ()
      file(REMOVE_RECURSE "${pages}")
    endif ()
  endif ()
  file(MAKE_DIRECTORY "${doc}")
  file(REMOVE "${doc}/CHANGELOG.md")
  configure_file("${CPACK_STIPPLE_SOURCE}/CHANGELOG.md" "${doc}/changelog" COPYONLY)
  configure_file("${CMAKE_CURRENT_LIST_DIR}/copyright" "${doc}/copyright" COPYONLY)
  file(WRITE "${doc}/changelog.Debian"
    "stipple (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium\n\n"
    "  * Made by cpack; changelog.gz tells what is new.\n\n"
    " -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
  if (EXISTS "${CMAKE_CURRENT_LIST_DIR}/${component}/lintian-overrides")
    configure_file("${CMAKE_CURRENT_LIST_DIR}/${component}/lintian-overrides"
      "${root}/share/lintian/overrides/${package}" COPYONLY)
  endif ()
  file(GLOB compressed "${doc}/changelog" "${doc}/changelog.Debian" "${root}/share/man/man1/*.1")
  foreach (file IN LISTS compressed)
    stipple_must(gzip -9nf "${file}")
  endforeach ()
  file(GLOB_RECURSE readable "${root}/share/*")
  foreach (file IN LISTS readable)
    if (NOT IS_SYMLINK "${file}")
      file(CHMOD "${file}" PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
    endif ()
  endforeach ()
  # The folders that this script made: CPack's own have these permissions already.
  file(GLOB_RECURSE folders LIST_DIRECTORIES ON "${root}/*")
  foreach (folder IN LISTS folders)
    if (IS_DIRECTORY "${folder}" AND NOT IS_SYMLINK "${folder}")
      file(CHMOD "${folder}" PERMISSIONS
        OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
    endif ()
  endforeach ()
endforeach ()
