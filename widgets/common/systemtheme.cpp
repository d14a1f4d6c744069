// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/systemtheme.h"

#include <QPalette>

#include <algorithm>
#include <cmath>

namespace mb {
namespace {

constexpr double words = 4.5; ///< contrast that text needs
constexpr double bold = 7.0;  ///< the same for eyes that need more
constexpr double shape = 3.0; ///< edges of controls, and traces a little more
constexpr double trace = 3.4;
constexpr double extreme = 18.5; ///< text on a ground that was chosen for its contrast
constexpr int steps = 40;

QColor mixed(const QColor &from, const QColor &to, double share)
{
    const auto part = [share](int a, int b) { return static_cast<int>(std::lround(a + (b - a) * share)); };
    return {part(from.red(), to.red()), part(from.green(), to.green()), part(from.blue(), to.blue())};
}

/// The end of grey that stands out more from a colour.
QColor opposite(const QColor &ground)
{
    const QColor black(Qt::black);
    const QColor white(Qt::white);
    return contrast(ground, black) > contrast(ground, white) ? black : white;
}

/// As far towards the opposite of its grounds as it needs to be read on all of them; they are all light or all dark.
QColor legible(const QColor &ink, std::initializer_list<QColor> grounds, double least)
{
    const QColor end = opposite(*grounds.begin());
    for (int i = 0; i < steps; ++i) {
        const QColor tried = mixed(ink, end, double(i) / steps);
        if (std::ranges::all_of(grounds, [&](const QColor &ground) { return contrast(tried, ground) >= least; }))
            return tried;
    }
    return end;
}

/// The other way round: a ground on which these inks can be read, as near to the wished one as that is possible.
QColor groundFor(const QColor &wished, const QColor &plain, std::initializer_list<QColor> inks, double least)
{
    for (int i = 0; i < steps; ++i) {
        const QColor tried = mixed(wished, plain, double(i) / steps);
        if (std::ranges::all_of(inks, [&](const QColor &ink) { return contrast(ink, tried) >= least; }))
            return tried;
    }
    return plain;
}

/// What stands out enough from the text is a surface; a palette of odd colours has one surface only.
QColor surface(const QColor &wished, const QColor &ink, const QColor &window)
{
    return contrast(wished, ink) >= bold ? wished : window;
}

void setSurfaces(Theme &t, const QPalette &palette, bool high)
{
    t.window = palette.color(QPalette::Active, QPalette::Window);
    if (contrast(t.window, opposite(t.window)) < bold) // a middle grey, on which nothing is read well
        t.window = opposite(opposite(t.window));
    t.text = legible(palette.color(QPalette::Active, QPalette::WindowText), {t.window}, bold);
    t.canvas = surface(palette.color(QPalette::Active, QPalette::Base), t.text, t.window);
    t.control = surface(palette.color(QPalette::Active, QPalette::Button), t.text, t.window);
    t.panel = high ? t.canvas : mixed(t.window, t.canvas, 0.5);
    t.head = t.canvas;
    t.hover = groundFor(mixed(t.control, t.text, 0.15), t.control, {t.text}, high ? bold : words);
    t.line = mixed(t.window, t.text, high ? 0.6 : 0.2);
    t.grid = mixed(t.canvas, t.text, high ? 0.3 : 0.1);
}

void setInks(Theme &t, const QPalette &palette, double least)
{
    const auto onAll = [&t, least](const QColor &ink) {
        return legible(ink, {t.window, t.canvas, t.head, t.panel, t.control, t.hover}, least);
    };
    t.outline
        = legible(mixed(t.window, t.text, 0.5), {t.window, t.canvas, t.head, t.panel}, least > words ? words : shape);
    t.text = onAll(t.text);
    t.dim = onAll(mixed(t.text, t.window, 0.25));
    t.faint = onAll(mixed(t.text, t.window, 0.4));
    t.accent = onAll(palette.color(QPalette::Active, QPalette::Link));
    t.ok = onAll(t.ok);
    t.caution = onAll(t.caution);
    t.danger = onAll(t.danger);
}

void setGrounds(Theme &t, const QPalette &palette, double least)
{
    const QColor highlight = palette.color(QPalette::Active, QPalette::Highlight);
    t.sel = groundFor(highlight, t.canvas, {t.text}, least);
    t.fill = legible(highlight, {t.onFill}, least);
    t.stop = legible(t.stop, {t.onFill}, least);
    t.demo = legible(t.demo, {t.onFill}, least);
    t.demoAlternate = legible(t.demoAlternate, {t.onFill}, least);
    const auto tint = [&](const QColor &state, std::initializer_list<QColor> inks) {
        return groundFor(mixed(t.panel, state, 0.15), t.panel, inks, least);
    };
    t.bannerCaution = tint(t.caution, {t.text, t.dim, t.caution});
    t.bannerDanger = tint(t.danger, {t.text, t.dim, t.danger});
    t.bannerOk = tint(t.ok, {t.text, t.dim, t.ok});
    t.bannerInfo = tint(t.accent, {t.text, t.dim, t.accent});
    t.editedTint = tint(t.accent, {t.text});
    t.errorTint = tint(t.danger, {t.text, t.danger});
}

} // namespace

bool isHighContrast(const QPalette &palette)
{
    const auto of = [&palette](QPalette::ColorRole ink, QPalette::ColorRole ground) {
        return contrast(palette.color(QPalette::Active, ink), palette.color(QPalette::Active, ground));
    };
    return of(QPalette::WindowText, QPalette::Window) >= extreme && of(QPalette::Text, QPalette::Base) >= extreme;
}

Theme systemTheme(const QPalette &palette, double bodyPointSize)
{
    const bool high = isHighContrast(palette);
    const double least = high ? bold : words;
    const QColor window = palette.color(QPalette::Active, QPalette::Window);
    Theme t = opposite(window) == QColor(Qt::white) ? darkTheme(bodyPointSize) : lightTheme(bodyPointSize);
    t.name = systemThemeName();
    setSurfaces(t, palette, high);
    setInks(t, palette, least);
    setGrounds(t, palette, least);
    for (QColor &colour : t.traces)
        colour = legible(colour, {t.canvas}, high ? words : trace);
    return t;
}

QStringList themeNames()
{
    return {QStringLiteral("dark"), QStringLiteral("light"), QStringLiteral("contrast"), systemThemeName()};
}

QString systemThemeName()
{
    return QStringLiteral("system");
}

Theme themeNamed(const QString &name, const QPalette &desktop, double bodyPointSize)
{
    if (name == systemThemeName() || (name.isEmpty() && isHighContrast(desktop)))
        return systemTheme(desktop, bodyPointSize);
    if (name == QLatin1String("contrast"))
        return contrastTheme(bodyPointSize);
    return name == QLatin1String("light") ? lightTheme(bodyPointSize) : darkTheme(bodyPointSize);
}

Theme contrastTheme(double bodyPointSize)
{
    QPalette palette;
    for (const auto role : {QPalette::Window, QPalette::Base, QPalette::AlternateBase, QPalette::Button})
        palette.setColor(role, Qt::black);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(role, Qt::white);
    palette.setColor(QPalette::Highlight, QColor(0x0050D0));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Link, QColor(0x7FC8FF));
    Theme t = systemTheme(palette, bodyPointSize);
    t.name = QStringLiteral("contrast");
    return t;
}

} // namespace mb
