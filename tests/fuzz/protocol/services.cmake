# Transport and diagnostic services.
tendonlife_add_fuzzer(fuzz_isotp
  SOURCES fuzz_isotp.cpp LIBS hal firmware_protocol lifemodel)
tendonlife_add_fuzzer(fuzz_uds
  SOURCES fuzz_uds.cpp LIBS hal firmware_protocol firmware_storage lifemodel)

# Writes the seeds that are committed in corpus/.
add_executable(make_services_seeds EXCLUDE_FROM_ALL make_services_seeds.cpp)
target_link_libraries(make_services_seeds PRIVATE
  hal firmware_protocol lifemodel project_warnings)
