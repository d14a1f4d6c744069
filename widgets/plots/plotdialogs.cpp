// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotdialogs.h"

#include "widgets/common/filechoice.h"
#include "widgets/common/labels.h"
#include "widgets/common/segmented.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

namespace mb {
namespace {

struct DialogText {
    Q_DECLARE_TR_FUNCTIONS(DialogText)
};

QDialog *makeDialog(QWidget &parent, const QString &title)
{
    auto *dialog = new QDialog(&parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    return dialog;
}

QDialogButtonBox *addButtons(QDialog &dialog, QVBoxLayout &column, const QString &accept)
{
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
    buttons->button(QDialogButtonBox::Ok)->setText(accept);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    column.addWidget(buttons);
    return buttons;
}

void askText(QWidget &parent, const QString &title, const QString &label, const QString &proposal,
    const QString &accept, std::function<void(const QString &)> done)
{
    QDialog *dialog = makeDialog(parent, title);
    auto *column = new QVBoxLayout(dialog);
    auto *field = new QLineEdit(proposal, dialog);
    field->setMaxLength(200);
    field->setAccessibleName(label);
    column->addWidget(textLabel(label, TextRole::Body, Tone::Text, dialog));
    column->addWidget(field);
    QPushButton *ok = addButtons(*dialog, *column, accept)->button(QDialogButtonBox::Ok);
    ok->setEnabled(!proposal.trimmed().isEmpty());
    QObject::connect(
        field, &QLineEdit::textChanged, ok, [ok](const QString &text) { ok->setEnabled(!text.trimmed().isEmpty()); });
    QObject::connect(dialog, &QDialog::accepted, &parent, [field, done = std::move(done)] { done(field->text()); });
    dialog->resize(360, dialog->sizeHint().height());
    dialog->open();
}

QListWidget *variableList(QDialog &dialog, const std::vector<SignalBook::Variable> &variables)
{
    auto *list = new QListWidget(&dialog);
    for (const SignalBook::Variable &variable : variables)
        list->addItem(variable.name);
    list->setAccessibleName(DialogText::tr("Signals that a formula may use"));
    list->setToolTip(DialogText::tr("Double click puts the name into the formula"));
    return list;
}

} // namespace

void askNote(QWidget &parent, std::function<void(const QString &)> done)
{
    askText(parent, DialogText::tr("Note at this time"), DialogText::tr("What happened"), {},
        DialogText::tr("Add note"), std::move(done));
}

void askName(QWidget &parent, const QString &title, const QString &proposal, std::function<void(const QString &)> done)
{
    askText(parent, title, DialogText::tr("Name"), proposal, DialogText::tr("Save"), std::move(done));
}

void askDerived(QWidget &parent, const ThemeSource &theme, const std::vector<SignalBook::Variable> &variables,
    std::function<QString(const QString &name, const QString &formula)> check,
    std::function<void(const QString &name, const QString &unit, const QString &formula)> done)
{
    QDialog *dialog = makeDialog(parent, DialogText::tr("Derived signal"));
    auto *column = new QVBoxLayout(dialog);
    auto *form = new QFormLayout;
    auto *name = new QLineEdit(dialog);
    auto *unit = new QLineEdit(dialog);
    auto *formula = new QLineEdit(dialog);
    unit->setPlaceholderText(DialogText::tr("counts/s², A, …"));
    formula->setPlaceholderText(QStringLiteral("average(derivative(d5_velocity), 0.1)"));
    form->addRow(DialogText::tr("Name"), name);
    form->addRow(DialogText::tr("Unit"), unit);
    form->addRow(DialogText::tr("Formula"), formula);
    column->addLayout(form);
    auto *wrong = textLabel({}, TextRole::Caption, Tone::Danger, dialog);
    wrong->setWordWrap(true);
    column->addWidget(wrong);
    auto *list = variableList(*dialog, variables);
    column->addWidget(list, 1);
    auto *help = textLabel(
        DialogText::tr(
            "+ − * / ^ ( ) · derivative(x) · integral(x) · average(x, seconds) · abs, sqrt, sin, min, max … · "
            "values are in the unit of the device"),
        TextRole::Caption, Tone::Dim, dialog);
    help->setWordWrap(true);
    column->addWidget(help);
    QPushButton *ok = addButtons(*dialog, *column, DialogText::tr("Add signal"))->button(QDialogButtonBox::Ok);
    const auto validate = [=] {
        const QString cause = check(name->text(), formula->text());
        wrong->setText(formula->text().isEmpty() ? QString() : cause);
        ok->setEnabled(cause.isEmpty());
    };
    QObject::connect(name, &QLineEdit::textChanged, dialog, validate);
    QObject::connect(formula, &QLineEdit::textChanged, dialog, validate);
    QObject::connect(list, &QListWidget::itemActivated, formula,
        [formula](QListWidgetItem *item) { formula->insert(item->text()); });
    QObject::connect(dialog, &QDialog::accepted, &parent,
        [=, done = std::move(done)] { done(name->text(), unit->text(), formula->text()); });
    validate();
    dialog->resize(theme.theme().u(440), theme.theme().u(420));
    dialog->open();
}

void askExport(
    QWidget &parent, Stretch seen, std::optional<Stretch> selection, std::function<void(const ExportChoice &)> done)
{
    QDialog *dialog = makeDialog(parent, DialogText::tr("Export samples"));
    auto *column = new QVBoxLayout(dialog);
    auto *range = new Segmented(DialogText::tr("Stretch"),
        {DialogText::tr("What is seen"), DialogText::tr("A … B"), DialogText::tr("Whole session")}, dialog);
    range->setSegmentEnabled(1, selection.has_value(), DialogText::tr("Show the cursors first: L"));
    range->setCurrent(selection ? 1 : 0);
    auto *signalsOf = new Segmented(DialogText::tr("Signals"),
        {DialogText::tr("Plotted signals"), DialogText::tr("All signals of all devices")}, dialog);
    auto *kind = new Segmented(
        DialogText::tr("Kind"), {DialogText::tr("CSV table"), DialogText::tr("MCAP recording")}, dialog);
    auto *help
        = textLabel(DialogText::tr("Both carry units, the devices with their parameters, notes, and how many samples "
                                   "were lost. MCAP opens in PlotJuggler and Foxglove."),
            TextRole::Caption, Tone::Dim, dialog);
    help->setWordWrap(true);
    for (QWidget *part : {static_cast<QWidget *>(range), static_cast<QWidget *>(signalsOf),
             static_cast<QWidget *>(kind), static_cast<QWidget *>(help)})
        column->addWidget(part);
    addButtons(*dialog, *column, DialogText::tr("Choose file…"));
    QObject::connect(dialog, &QDialog::accepted, &parent, [=, &parent, done = std::move(done)] {
        const std::optional<Stretch> stretches[] = {seen, selection, std::nullopt}; // as they are offered
        const QString filter
            = kind->current() == 0 ? DialogText::tr("Table (*.csv)") : DialogText::tr("MCAP recording (*.mcap)");
        askWhereToSave(parent, DialogText::tr("Export samples"), filter, {},
            [choice = ExportChoice{stretches[range->current()], signalsOf->current() == 1}, done](
                const QString &path) mutable {
                choice.path = path;
                done(choice);
            });
    });
    dialog->open();
}

} // namespace mb
