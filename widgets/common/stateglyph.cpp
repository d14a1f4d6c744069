// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/stateglyph.h"

#include "widgets/common/paintedicon.h"

#include <QCoreApplication>
#include <QPainter>

namespace mb {
namespace {

class GlyphEngine : public PaintedIcon {
public:
    GlyphEngine(GlyphState state, const QColor &color)
        : m_state(state)
        , m_color(color)
    {
    }
    void paint(QPainter *painter, const QRect &rect, QIcon::Mode, QIcon::State) override
    {
        paintGlyph(*painter, rect, m_state, m_color);
    }
    QIconEngine *clone() const override { return new GlyphEngine(*this); }

private:
    GlyphState m_state;
    QColor m_color;
};

} // namespace

Tone glyphTone(GlyphState state)
{
    switch (state) {
    case GlyphState::Online:
    case GlyphState::Stored:
    case GlyphState::Done: return Tone::Ok;
    case GlyphState::Moving:
    case GlyphState::Bootloader:
    case GlyphState::Duplicate:
    case GlyphState::Unassigned:
    case GlyphState::InRam:
    case GlyphState::Warning: return Tone::Caution;
    case GlyphState::Fault:
    case GlyphState::OutOfRange:
    case GlyphState::Recording: return Tone::Danger;
    case GlyphState::Edited:
    case GlyphState::Busy: return Tone::Accent;
    case GlyphState::Gone:
    case GlyphState::Assumed:
    case GlyphState::Volatile:
    case GlyphState::Waiting: return Tone::Faint;
    }
    return Tone::Faint;
}

QColor glyphColor(GlyphState state, const Theme &theme)
{
    return theme.tone(glyphTone(state));
}

QString glyphWord(GlyphState state)
{
    const auto word = [](const char *text) { return QCoreApplication::translate("mb::StateGlyph", text); };
    switch (state) {
    case GlyphState::Online: return word(QT_TRANSLATE_NOOP("mb::StateGlyph", "online"));
    case GlyphState::Moving: return word(QT_TRANSLATE_NOOP("mb::StateGlyph", "moving"));
    case GlyphState::Bootloader: return word(QT_TRANSLATE_NOOP("mb::StateGlyph", "in bootloader"));
    case GlyphState::Duplicate: return word(QT_TRANSLATE_NOOP("mb::StateGlyph", "2 ×"));
    case GlyphState::Unassigned: return word(QT_TRANSLATE_NOOP("mb::StateGlyph", "number 0"));
    case GlyphState::Fault: return word(QT_TRANSLATE_NOOP("mb::StateGlyph", "fault"));
    case GlyphState::Gone: return word(QT_TRANSLATE_NOOP("mb::StateGlyph", "no answer"));
    case GlyphState::Stored: return word(QT_TRANSLATE_NOOP("mb::StateGlyph", "stored"));
    case GlyphState::InRam: return word(QT_TRANSLATE_NOOP("mb::StateGlyph", "RAM, not in flash"));
    case GlyphState::Edited: return word(QT_TRANSLATE_NOOP("mb::StateGlyph", "edited"));
    case GlyphState::OutOfRange: return word(QT_TRANSLATE_NOOP("mb::StateGlyph", "out of range"));
    case GlyphState::Assumed: return word(QT_TRANSLATE_NOOP("mb::StateGlyph", "assumed"));
    case GlyphState::Volatile: return word(QT_TRANSLATE_NOOP("mb::StateGlyph", "volatile"));
    case GlyphState::Busy: return word(QT_TRANSLATE_NOOP("mb::StateGlyph", "busy"));
    case GlyphState::Done: return word(QT_TRANSLATE_NOOP("mb::StateGlyph", "done"));
    case GlyphState::Waiting: return word(QT_TRANSLATE_NOOP("mb::StateGlyph", "waiting"));
    case GlyphState::Warning: return word(QT_TRANSLATE_NOOP("mb::StateGlyph", "warning"));
    case GlyphState::Recording: return word(QT_TRANSLATE_NOOP("mb::StateGlyph", "recording"));
    }
    return {};
}

QIcon glyphIcon(GlyphState state, const Theme &theme)
{
    return QIcon(new GlyphEngine(state, glyphColor(state, theme)));
}

StateGlyph::StateGlyph(const ThemeSource &theme, GlyphState state, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_state(state)
{
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(glyphWord(state));
    followTheme(theme, *this);
}

void StateGlyph::setState(GlyphState state)
{
    if (m_state == state)
        return;
    m_state = state;
    setAccessibleName(glyphWord(state));
    update();
}

QSize StateGlyph::sizeHint() const
{
    return {m_theme.theme().u(12), m_theme.theme().u(12)};
}

void StateGlyph::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    paintGlyph(painter, rect(), m_state, glyphColor(m_state, m_theme.theme()));
}

} // namespace mb
