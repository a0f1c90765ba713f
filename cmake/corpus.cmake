# Puts the corpus of past failures into rayproof-check, so that it runs first wherever the program is.

# rayproof_embed_corpus(TARGET FOLDER): adds FOLDER/*.jsonl to TARGET as the function corpus_files().
function(rayproof_embed_corpus target folder)
  file(GLOB files CONFIGURE_DEPENDS ${folder}/*.jsonl)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  set(entries "")
  foreach(file IN LISTS files)
    get_filename_component(name ${file} NAME)
    file(READ ${file} text)
    string(APPEND entries "      {\"${name}\", R\"corpus(${text})corpus\"},\n")
  endforeach()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/corpus_files.cpp)
  file(CONFIGURE OUTPUT ${source} @ONLY CONTENT [[
#include "programs/check/corpus.hpp"

std::vector<rayproof::check::CorpusFile> rayproof::check::corpus_files() {
  return {
@entries@  };
}
]])
  target_sources(${target} PRIVATE ${source})
endfunction()
