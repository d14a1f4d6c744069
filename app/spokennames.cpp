// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/spokennames.h"

#include "widgets/common/spoken.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QFileDialog>
#include <QInputDialog>
#include <QLineEdit>
#include <QScrollArea>
#include <QSpinBox>

namespace mb {
namespace {

void name(QComboBox &box)
{
    const QString called = box.accessibleName();
    if (called.isEmpty())
        return;
    if (box.accessibleDescription().isEmpty() && box.toolTip().isEmpty())
        box.setAccessibleDescription(called);
    if (box.view()->accessibleName().isEmpty())
        box.view()->setAccessibleName(called);
    if (QLineEdit *field = box.lineEdit(); field && field->accessibleName().isEmpty())
        field->setAccessibleName(called);
}

/// The nearest thing around or in it that has a name.
void name(QScrollArea &area)
{
    if (!area.accessibleName().isEmpty())
        return;
    if (area.widget() && !area.widget()->accessibleName().isEmpty())
        return area.setAccessibleName(area.widget()->accessibleName());
    for (const QWidget *around = area.parentWidget(); around; around = around->parentWidget()) {
        const QString called = around->accessibleName().isEmpty() ? around->windowTitle() : around->accessibleName();
        if (!called.isEmpty())
            return area.setAccessibleName(called);
    }
}

/// Lists and trees of Qt's form for files.
void name(QFileDialog &dialog)
{
    for (QAbstractItemView *view : dialog.findChildren<QAbstractItemView *>()) {
        if (!view->accessibleName().isEmpty() || qobject_cast<QComboBox *>(view->parentWidget()->parentWidget()))
            continue;
        view->setAccessibleName(
            view->objectName() == QLatin1String("sidebar") ? SpokenNames::tr("Places") : SpokenNames::tr("Files"));
    }
    for (QComboBox *box : dialog.findChildren<QComboBox *>()) {
        if (box->accessibleName().isEmpty()) {
            box->setAccessibleName(box->objectName() == QLatin1String("lookInCombo") ? SpokenNames::tr("Folder")
                                                                                     : SpokenNames::tr("Kind of file"));
            name(*box);
        }
    }
}

/// The one field of it is called as the question.
void name(QInputDialog &dialog)
{
    for (QWidget *field : dialog.findChildren<QWidget *>()) {
        const bool asked = qobject_cast<QLineEdit *>(field) || qobject_cast<QAbstractSpinBox *>(field);
        if (asked && field->accessibleName().isEmpty())
            field->setAccessibleName(dialog.labelText());
    }
}

} // namespace

bool SpokenNames::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::Show)
        return false;
    if (auto *box = qobject_cast<QComboBox *>(watched))
        name(*box);
    else if (auto *area = qobject_cast<QScrollArea *>(watched))
        name(*area);
    else if (auto *files = qobject_cast<QFileDialog *>(watched))
        name(*files);
    else if (auto *question = qobject_cast<QInputDialog *>(watched))
        name(*question);
    return false;
}

} // namespace mb
