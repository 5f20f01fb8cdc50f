// What a plot shows is looked at; here it is only that it is drawn, the same each time, and that
// data that could break it do not.
#include "experiments/common/plot.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>

#include <cairo/cairo.h>
#include <gtest/gtest.h>

namespace thigma::plot {
namespace {

/// Pixels of a PNG as 0xRRGGBB.
struct Picture {
  int width = 0, height = 0;
  std::vector<unsigned> pixels;
};

cairo_status_t read_some(void* from, unsigned char* bytes, unsigned int count) {
  std::string& rest = *static_cast<std::string*>(from);
  if (rest.size() < count) return CAIRO_STATUS_READ_ERROR;
  std::memcpy(bytes, rest.data(), count);
  rest.erase(0, count);
  return CAIRO_STATUS_SUCCESS;
}

Picture decode(std::string png) {
  const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface(
      cairo_image_surface_create_from_png_stream(read_some, &png), cairo_surface_destroy);
  Picture picture;
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) return picture;
  picture.width = cairo_image_surface_get_width(surface.get());
  picture.height = cairo_image_surface_get_height(surface.get());
  const unsigned char* data = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      unsigned pixel = 0;
      std::memcpy(&pixel, data + y * stride + 4 * x, 4);
      picture.pixels.push_back(pixel & 0xffffffu);
    }
  }
  return picture;
}

/// Pixels of a colour, to a rounding of each channel.
int count(const Picture& picture, unsigned color) {
  int found = 0;
  for (const unsigned p : picture.pixels) {
    bool is_near = true;
    for (const int shift : {0, 8, 16}) {
      const int difference =
          static_cast<int>((p >> shift) & 0xff) - static_cast<int>((color >> shift) & 0xff);
      is_near = is_near && std::abs(difference) <= 2;
    }
    found += is_near ? 1 : 0;
  }
  return found;
}

constexpr unsigned kBlue = 0x0073b2;  // first of the palette

Figure one_curve(const std::vector<double>& x, const std::vector<double>& y, bool is_log = false) {
  Figure figure{.title = "t", .width = 400, .panel_height = 200};
  figure.panels = {{.x = {.label = "x [s]"},
                    .y = {.label = "y [N]", .is_log = is_log},
                    .series = {{.label = "a", .x = x, .y = y, .width = 4.0}}}};
  return figure;
}

TEST(Plot, HasTheSizeThatWasAskedForAtTwoPixelsAPoint) {
  const Picture picture = decode(figure_bytes(one_curve({0.0, 1.0}, {0.0, 1.0})));
  EXPECT_EQ(picture.width, 800);
  EXPECT_GE(picture.height, 400);
}

TEST(Plot, DrawsTheCurveInItsColour) {
  const int drawn = count(decode(figure_bytes(one_curve({0.0, 1.0}, {0.0, 1.0}))), kBlue);
  // its line in the legend alone
  const int nothing = count(decode(figure_bytes(one_curve({}, {}))), kBlue);
  EXPECT_GT(drawn, nothing + 500);
}

TEST(Plot, IsTheSameEachTime) {
  const Figure figure = one_curve({0.0, 1.0, 2.0}, {0.0, 3.0, 1.0});
  EXPECT_EQ(figure_bytes(figure), figure_bytes(figure));
}

TEST(Plot, TakesDataThatHaveNoPlace) {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const bool is_log : {false, true}) {
    EXPECT_FALSE(
        figure_bytes(one_curve({0.0, 1.0, 2.0}, {nan, infinity, -infinity}, is_log)).empty());
    EXPECT_FALSE(figure_bytes(one_curve({0.0, 1.0, 2.0}, {0.0, -1.0, 0.0}, is_log)).empty());
    EXPECT_FALSE(figure_bytes(one_curve({5.0}, {5.0}, is_log)).empty());
  }
  EXPECT_FALSE(figure_bytes(Figure{}).empty());
}

TEST(Plot, LeavesAGapWhereAValueIsMissing) {
  const double nan = std::nan("");
  const int whole =
      count(decode(figure_bytes(one_curve({0.0, 1.0, 2.0, 3.0}, {1.0, 1.0, 1.0, 1.0}))), kBlue);
  const int broken =
      count(decode(figure_bytes(one_curve({0.0, 1.0, 2.0, 3.0}, {1.0, nan, 1.0, 1.0}))), kBlue);
  EXPECT_LT(broken, whole / 2 + 200);
}

TEST(Histogram, CountsEveryValueOnce) {
  const std::vector<double> values = {0.0, 0.1, 0.9, 1.0, 1.0, 2.0, std::nan("")};
  const Series s = histogram("", values, 4);
  ASSERT_EQ(s.x.size(), 5u);
  EXPECT_EQ(s.x.front(), 0.0);
  EXPECT_EQ(s.x.back(), 2.0);
  EXPECT_EQ((std::vector<double>{s.y[0], s.y[1], s.y[2], s.y[3]}),
            (std::vector<double>{2.0, 1.0, 2.0, 1.0}));
}

TEST(Histogram, HasBinsOfEqualRatioOnALogarithmicAxis) {
  const Series s = histogram("", std::vector<double>{1.0, 5.0, 50.0, 100.0, -1.0, 0.0}, 2, true);
  ASSERT_EQ(s.x.size(), 3u);
  EXPECT_NEAR(s.x[1], 10.0, 1e-9);
  EXPECT_EQ(s.y[0], 2.0);
  EXPECT_EQ(s.y[1], 2.0);
}

TEST(Histogram, TakesEqualValues) {
  const Series s = histogram("", std::vector<double>{3.0, 3.0}, 3);
  double total = 0.0;
  for (std::size_t i = 0; i + 1 < s.y.size(); ++i) total += s.y[i];
  EXPECT_EQ(total, 2.0);
}

TEST(Plot, LinesAreLinesInSvgAndPdf) {
  const Figure figure = one_curve({0.0, 1.0, 2.0}, {0.0, 1.0, 0.5});
  const std::string svg = figure_bytes(figure, PageFormat::svg);
  EXPECT_NE(svg.find("<svg"), std::string::npos);
  EXPECT_NE(svg.find("<path"), std::string::npos);
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
  const std::string pdf = figure_bytes(figure, PageFormat::pdf);
  EXPECT_TRUE(pdf.starts_with("%PDF-"));
  EXPECT_NE(pdf.find("%%EOF"), std::string::npos);
  EXPECT_EQ(pdf, figure_bytes(figure, PageFormat::pdf));
}

TEST(Plot, TheEndingOfAFileSaysItsFormat) {
  EXPECT_EQ(page_format("a.png"), PageFormat::png);
  EXPECT_EQ(page_format("a.b/c.svg"), PageFormat::svg);
  EXPECT_EQ(page_format("c.pdf"), PageFormat::pdf);
  EXPECT_EQ(page_format("/tmp.x/drawn"), PageFormat::png);
  for (const char* other : {"a.jpg", "a.pdf.mcap", "/tmp/.hidden"})
    EXPECT_FALSE(page_format(other)) << other;
}

}  // namespace
}  // namespace thigma::plot
