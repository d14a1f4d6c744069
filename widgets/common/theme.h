// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QObject>
#include <QString>
#include <array>

class QWidget;

namespace mb {

/// What a colour of text or of a shape says. Red, amber and green mean state, never decoration.
enum class Tone { Text, Dim, Faint, Accent, Ok, Caution, Danger };

/// The quantity that a trace shows; it alone decides the colour. `Setpoint` and `Neutral` are grey: wished for, not
/// measured.
enum class TraceRole { Setpoint, Position, Velocity, Current, Duty, Error, Temperature, Neutral };
inline constexpr int TraceRoleCount = 8;

/// Text sizes, all relative to the system font (never a family of our own).
enum class TextRole { Body, Emphasis, Caption, Section, Title, Large, Stop, Verdict, Raw };

/// Every colour and size token of the design. A plain value: copy it freely.
struct Theme {
    QString name;     ///< "dark", "light", "contrast", "system" (systemtheme.h)
    bool dark = true; ///< light text on dark surfaces
    bool reducedMotion = false;
    double bodyPointSize = 10.0; ///< of the system font; all sizes follow it

    QColor canvas, window, head, panel, control, hover, line, grid, outline;
    QColor text, dim, faint, accent, fill, onFill, sel;
    QColor ok, caution, danger, stop, armed, onArmed, demo, demoAlternate;
    QColor bannerCaution, bannerDanger, bannerOk, bannerInfo;
    QColor editedTint, errorTint; ///< table rows
    std::array<QColor, TraceRoleCount> traces;

    /// A length given at 10 pt, in pixels of this theme. Never under 1 for n > 0.
    int u(double n) const;
    QColor tone(Tone tone) const;
    QColor trace(TraceRole role) const { return traces.at(static_cast<std::size_t>(role)); }
    /// The body font in another role; `body` is normally QApplication::font() or the widget's own font.
    QFont font(TextRole role, const QFont &body) const;

    bool operator==(const Theme &other) const;
};

Theme darkTheme(double bodyPointSize = 10.0);
Theme lightTheme(double bodyPointSize = 10.0);

/// Contrast ratio 1 … 21 of two opaque colours (WCAG 2.1).
double contrast(const QColor &a, const QColor &b);

/// Hands the theme to whoever paints by hand. Passed as a constructor argument; must outlive the widgets.
class ThemeSource : public QObject {
    Q_OBJECT
public:
    explicit ThemeSource(Theme theme, QObject *parent = nullptr);
    const Theme &theme() const { return m_theme; }
    void setTheme(const Theme &theme);

Q_SIGNALS:
    void changed();

private:
    Theme m_theme;
};

/// For one that is painted by hand: with another theme it is of another size, and painted again.
void followTheme(const ThemeSource &theme, QWidget &widget);

} // namespace mb
