#pragma once
/// \file
/// The script and style of pages, put into the program when it is configured (embedded.cmake).

namespace rayproof::viz {

extern const char* const page_html;           ///< page.html, a walkthrough's page with its parts by name
extern const char* const slider_html;         ///< slider.html
extern const char* const page_style_sheet;    ///< page.css
extern const char* const scene_style_sheet;   ///< scene.css
extern const char* const walkthrough_script;  ///< our own scripts, in the order in which they need each other
extern const char* const three_script;        ///< three.js and what we use of its examples; empty without it

}  // namespace rayproof::viz
