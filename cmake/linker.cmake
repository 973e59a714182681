# SPDX-License-Identifier: MIT
# Link with lld when it is there: a hundred programs that each hold the generator, in a fifth of the time.
find_program(TORSOR_LLD ld.lld)
mark_as_advanced(TORSOR_LLD)
if(TORSOR_LLD)
  add_link_options(-fuse-ld=lld)
endif()
