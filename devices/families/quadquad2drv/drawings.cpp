// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/drawings.h"

#include <QtGlobal>

#include <array>

namespace mb::quadquad2drv {
namespace {

constexpr std::string_view boardLayer = R"svg(
<rect x="112" y="8" width="180" height="152" rx="6" fill="{control}" stroke="{outline}" stroke-width="1.5"/>
<text x="202" y="150" text-anchor="middle" font-size="11" fill="{dim}">QuadQuad2Drv</text>
<rect x="190" y="88" width="44" height="40" fill="{panel}" stroke="{outline}"/>
<circle cx="196" cy="94" r="2" fill="{outline}"/>
)svg";

constexpr std::string_view adapterLayer = R"svg(
<rect x="8" y="28" width="62" height="104" rx="4" fill="{panel}" stroke="{outline}" stroke-width="1.5"/>
<text x="2" y="21" font-size="11" fill="{dim}">{0}</text>
)svg";

constexpr std::string_view wireLayer = R"svg(
<g stroke-width="2" stroke-linecap="round">
<line x1="62" y1="48" x2="122" y2="48" stroke="{danger}"/>
<line x1="62" y1="70" x2="122" y2="92" stroke="{accent}"/>
<line x1="62" y1="92" x2="122" y2="70" stroke="{ok}"/>
<line x1="62" y1="114" x2="122" y2="114" stroke="{dim}"/>
</g>
<g fill="{canvas}" stroke="{outline}">
<circle cx="62" cy="48" r="4"/><circle cx="122" cy="48" r="4"/>
<circle cx="62" cy="70" r="4"/><circle cx="122" cy="92" r="4"/>
<circle cx="62" cy="92" r="4"/><circle cx="122" cy="70" r="4"/>
<circle cx="62" cy="114" r="4"/><circle cx="122" cy="114" r="4"/>
</g>
<g font-size="11" fill="{text}">
<text x="12" y="52">3V3</text><text x="130" y="52">3V3</text>
<text x="12" y="74">TX</text><text x="130" y="96">RX</text>
<text x="12" y="96">RX</text><text x="130" y="74">TX</text>
<text x="12" y="118">GND</text><text x="130" y="118">GND</text>
</g>
)svg";

constexpr std::string_view pinLayer = R"svg(
<g fill="{canvas}" stroke="{outline}"><circle cx="216" cy="52" r="4"/><circle cx="246" cy="52" r="4"/></g>
<g font-size="11" fill="{text}" text-anchor="middle"><text x="208" y="75">AUX1</text><text x="254" y="75">AUX2</text></g>
)svg";

/// A cap over both pins …
constexpr std::string_view capOn = R"svg(
<rect x="207" y="43" width="48" height="18" rx="4" fill="{accent}" stroke="{accent}" stroke-width="2"/>
<line x1="216" y1="52" x2="246" y2="52" stroke="{onfill}" stroke-width="2"/>
)svg";

/// … or beside them, with the way it went.
constexpr std::string_view capOff = R"svg(
<rect x="207" y="13" width="48" height="18" rx="4" fill="none" stroke="{accent}" stroke-width="1.5" stroke-dasharray="6,3"/>
<g stroke="{accent}" stroke-width="1.5">
<line x1="231" y1="48" x2="231" y2="34"/><line x1="231" y1="34" x2="228" y2="38"/><line x1="231" y1="34" x2="234" y2="38"/>
</g>
)svg";

constexpr std::array closedLayers{boardLayer, adapterLayer, wireLayer, pinLayer, capOn};
constexpr std::array openLayers{boardLayer, adapterLayer, wireLayer, pinLayer, capOff};
constexpr std::array<std::string_view, 1> drawingWords{QT_TRANSLATE_NOOP("table", "adapter, 3.3 V")};

} // namespace

const Drawing jumperClosed{
    .width = 300,
    .height = 168,
    .layers = closedLayers,
    .words = drawingWords,
    .description = QT_TRANSLATE_NOOP(
        "table", "Drawing: the jumper connects AUX1 and AUX2; adapter TX to board RX, RX to TX, 3.3 V, GND"),
};
const Drawing jumperOpen{
    .width = 300,
    .height = 168,
    .layers = openLayers,
    .words = drawingWords,
    .description = QT_TRANSLATE_NOOP("table", "Drawing: the jumper between AUX1 and AUX2 is taken out"),
};

} // namespace mb::quadquad2drv
