// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/theme.h"

#include <QFontDatabase>
#include <QFontInfo>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <tuple>

namespace mb {
namespace {

auto surfaces(const Theme &t)
{
    return std::tie(t.canvas, t.window, t.head, t.panel, t.control, t.hover, t.line, t.grid, t.outline, t.text, t.dim,
        t.faint, t.accent, t.fill, t.onFill, t.sel);
}

auto states(const Theme &t)
{
    return std::tie(t.ok, t.caution, t.danger, t.stop, t.armed, t.onArmed, t.demo, t.demoAlternate, t.bannerCaution,
        t.bannerDanger, t.bannerOk, t.bannerInfo, t.editedTint, t.errorTint, t.traces);
}

double luminance(const QColor &color)
{
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

void setSharedColours(Theme &t)
{
    t.onFill = QColor(0xFFFFFF);
    t.armed = QColor(0xF2B23E);
    t.onArmed = QColor(0x14181D);
    t.demo = QColor(0x4A55C4);
    t.demoAlternate = QColor(0x3F49AD);
}

} // namespace

int Theme::u(double n) const
{
    const int pixels = static_cast<int>(std::lround(n * bodyPointSize / 10.0));
    return n > 0 ? std::max(1, pixels) : pixels;
}

QColor Theme::tone(Tone tone) const
{
    switch (tone) {
    case Tone::Text: return text;
    case Tone::Dim: return dim;
    case Tone::Faint: return faint;
    case Tone::Accent: return accent;
    case Tone::Ok: return ok;
    case Tone::Caution: return caution;
    case Tone::Danger: return danger;
    }
    return text;
}

QFont Theme::font(TextRole role, const QFont &body) const
{
    QFont font = role == TextRole::Raw ? QFontDatabase::systemFont(QFontDatabase::FixedFont) : body;
    constexpr std::array<double, 9> scale{1.0, 1.0, 0.85, 0.85, 1.15, 1.5, 1.3, 7.5, 0.92};
    if (role == TextRole::Raw && !QFontInfo(font).fixedPitch())
        font.setFamily(QStringLiteral("monospace")); // a platform without settings, such as offscreen
    font.setPointSizeF(bodyPointSize * scale.at(static_cast<std::size_t>(role)));
    const bool isBold = role == TextRole::Emphasis || role == TextRole::Section || role == TextRole::Title
        || role == TextRole::Stop || role == TextRole::Verdict;
    font.setWeight(isBold ? QFont::Bold : QFont::Normal);
    if (role == TextRole::Section) {
        font.setCapitalization(QFont::AllUppercase);
        font.setLetterSpacing(QFont::PercentageSpacing, 106);
    }
    return font;
}

bool Theme::operator==(const Theme &other) const
{
    return name == other.name && dark == other.dark && reducedMotion == other.reducedMotion
        && qFuzzyCompare(bodyPointSize, other.bodyPointSize) && surfaces(*this) == surfaces(other)
        && states(*this) == states(other);
}

Theme darkTheme(double bodyPointSize)
{
    Theme t;
    t.name = QStringLiteral("dark");
    t.dark = true;
    t.bodyPointSize = bodyPointSize;
    setSharedColours(t);
    t.canvas = QColor(0x14181D);
    t.window = QColor(0x1B2027);
    t.head = QColor(0x11151A);
    t.panel = QColor(0x222830);
    t.control = QColor(0x2B323C);
    t.hover = QColor(0x363F4A);
    t.line = QColor(0x303843);
    t.grid = QColor(0x242B33);
    t.outline = QColor(0x6C7886);
    t.text = QColor(0xE8ECF1);
    t.dim = QColor(0xAAB4C0);
    t.faint = QColor(0x8F99A7);
    t.accent = QColor(0x9AA5FF);
    t.fill = QColor(0x525ECF);
    t.sel = QColor(0x2C3360);
    t.ok = QColor(0x4DC08F);
    t.caution = QColor(0xF2B23E);
    t.danger = QColor(0xFF7A6B);
    t.stop = QColor(0xCF2A1E);
    t.bannerCaution = QColor(0x352C1B);
    t.bannerDanger = QColor(0x3A2323);
    t.bannerOk = QColor(0x1C3229);
    t.bannerInfo = QColor(0x252B48);
    t.editedTint = QColor(0x1D2233);
    t.errorTint = QColor(0x3A2323);
    t.traces = {QColor(0xF2F2F2), QColor(0x56B4E9), QColor(0xF0E442), QColor(0xD55E00), QColor(0xCC79A7),
        QColor(0x2F6FDE), QColor(0x009E73), QColor(0xAAB4C0)};
    return t;
}

Theme lightTheme(double bodyPointSize)
{
    Theme t;
    t.name = QStringLiteral("light");
    t.dark = false;
    t.bodyPointSize = bodyPointSize;
    setSharedColours(t);
    t.canvas = QColor(0xFFFFFF);
    t.window = QColor(0xF2F4F7);
    t.head = QColor(0xFFFFFF);
    t.panel = QColor(0xFFFFFF);
    t.control = QColor(0xFFFFFF);
    t.hover = QColor(0xE6EAEF);
    t.line = QColor(0xD3D9E0);
    t.grid = QColor(0xE7EBEF);
    t.outline = QColor(0x7D8894);
    t.text = QColor(0x171C22);
    t.dim = QColor(0x47525E);
    t.faint = QColor(0x5F6A76);
    t.accent = QColor(0x3D49C4);
    t.fill = QColor(0x3D49C4);
    t.sel = QColor(0xDFE3FB);
    t.ok = QColor(0x0A7547);
    t.caution = QColor(0x8F5A00);
    t.danger = QColor(0x8F0F22);
    t.stop = QColor(0xC4261C);
    t.bannerCaution = QColor(0xFDF1D9);
    t.bannerDanger = QColor(0xFCE9E7);
    t.bannerOk = QColor(0xE3F4EC);
    t.bannerInfo = QColor(0xE8EBFC);
    t.editedTint = QColor(0xF4F5FE);
    t.errorTint = QColor(0xFCE9E7);
    t.traces = {QColor(0x1A1A1A), QColor(0x1F8FD6), QColor(0x7C7A00), QColor(0xB0508C), QColor(0x1B2A8C),
        QColor(0x007A5A), QColor(0x663300), QColor(0x47525E)};
    return t;
}

double contrast(const QColor &a, const QColor &b)
{
    const double la = luminance(a);
    const double lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

ThemeSource::ThemeSource(Theme theme, QObject *parent)
    : QObject(parent)
    , m_theme(std::move(theme))
{
}

void ThemeSource::setTheme(const Theme &theme)
{
    if (m_theme == theme)
        return;
    m_theme = theme;
    Q_EMIT changed();
}

void followTheme(const ThemeSource &theme, QWidget &widget)
{
    QObject::connect(&theme, &ThemeSource::changed, &widget, [&widget] {
        widget.updateGeometry();
        widget.update();
    });
}

} // namespace mb
