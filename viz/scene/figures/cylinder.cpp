#include "viz/scene/figures/make_figures.hpp"

namespace rayproof::render {

template std::unique_ptr<Figures<float>> make_figures<cylinder::Topic, float>(std::string_view,
                                                                              const Members&);
template std::unique_ptr<Figures<double>> make_figures<cylinder::Topic, double>(std::string_view,
                                                                                const Members&);

}  // namespace rayproof::render
