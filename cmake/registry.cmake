# Puts the registry of peers into rayproof-check, which finds their programs beside itself.

# rayproof_embed_registry(TARGET FILE): adds the text of FILE to TARGET as the function peer_registry().
function(rayproof_embed_registry target file)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(READ ${file} text)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/peer_registry.cpp)
  file(CONFIGURE OUTPUT ${source} @ONLY CONTENT [[
#include "programs/check/peers.hpp"

std::string rayproof::check::peer_registry() {
  return R"registry(@text@)registry";
}
]])
  target_sources(${target} PRIVATE ${source})
endfunction()
