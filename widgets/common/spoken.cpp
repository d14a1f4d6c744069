// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/spoken.h"

#include <QAccessible>
#include <QTimer>
#include <QWidget>

namespace mb {
namespace {

constexpr std::chrono::seconds speakingPace(1);

/// Between two tellings of one widget: what comes meanwhile waits, and only the last of it is told.
class Pace : public QTimer {
public:
    explicit Pace(QWidget &widget)
        : QTimer(&widget)
    {
        setSingleShot(true);
        callOnTimeout(this, [this, &widget] {
            if (widget.accessibleDescription() == m_next)
                return;
            widget.setAccessibleDescription(m_next);
            start(speakingPace);
        });
    }
    void say(QWidget &widget, const QString &description)
    {
        m_next = description;
        if (isActive() || widget.accessibleDescription() == description)
            return;
        widget.setAccessibleDescription(description);
        start(speakingPace);
    }

private:
    QString m_next;
};

} // namespace

void setSpoken(QWidget &widget, const QString &name, const QString &description)
{
    if (widget.accessibleName() != name)
        widget.setAccessibleName(name);
    if (widget.accessibleDescription() != description)
        widget.setAccessibleDescription(description);
}

void setSpokenLive(QWidget &widget, const QString &description)
{
    const auto timers = widget.findChildren<QTimer *>(QString(), Qt::FindDirectChildrenOnly);
    Pace *pace = nullptr;
    for (QTimer *timer : timers) {
        if (auto *ours = dynamic_cast<Pace *>(timer))
            pace = ours;
    }
    if (!pace)
        pace = new Pace(widget);
    pace->say(widget, description);
}

void announce(QWidget &widget, const QString &words)
{
    widget.setAccessibleName(words); // which tells the bus that the name is another one
    QAccessibleEvent event(&widget, QAccessible::Alert);
    QAccessible::updateAccessibility(&event);
}

} // namespace mb
