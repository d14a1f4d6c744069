// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/service/recipeform.h"

#include "experiment/metrics.h"
#include "model/family.h"
#include "service/recipe.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/displayunits.h"
#include "widgets/common/filechoice.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/numberfield.h"
#include "widgets/common/numberformat.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QSignalBlocker>
#include <QTableWidget>

#include <algorithm>

namespace mb {
namespace {

enum AcceptColumn { AcceptKey, AcceptLeast, AcceptGreatest, AcceptColumns };

std::vector<std::string_view> acceptKeys()
{
    std::vector<std::string_view> keys;
    for (const tuning::MetricKey &metric : tuning::metricKeys())
        keys.push_back(metric.key);
    keys.insert(keys.end(),
        {service::figure::resistance, service::figure::friction, service::figure::gain, service::figure::encoder});
    return keys;
}

void put(QJsonObject &object, const QStringList &path, int at, const QJsonValue &value)
{
    const QString &key = path.at(at);
    if (at + 1 == path.size()) {
        object.insert(key, value);
        return;
    }
    QJsonObject inner = object.value(key).toObject();
    put(inner, path, at + 1, value);
    object.insert(key, inner);
}

QJsonValue at(const QJsonObject &object, const QString &path)
{
    QJsonValue value = object;
    for (const QString &key : path.split(QLatin1Char('.')))
        value = value.toObject().value(key);
    return value;
}

/// What is no number stays as it was typed, so that it is found with its line.
QJsonValue numberOf(const QString &typed)
{
    const auto number = parseNumber(typed);
    return number ? QJsonValue(*number) : QJsonValue(typed.trimmed());
}

QString wordOf(const QJsonValue &value)
{
    return value.isDouble() ? editText(value.toDouble()) : value.toString();
}

} // namespace

RecipeForm::RecipeForm(std::span<const Family *const> families, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_families(families)
    , m_theme(theme)
{
    auto *column = new QVBoxLayout(this);
    buildUnit(*column);
    column->addWidget(buildTest());
    column->addStretch(1);
    connect(m_family, qOverload<int>(&QComboBox::currentIndexChanged), this, &RecipeForm::followFamily);
    followFamily();
}

void RecipeForm::buildUnit(QVBoxLayout &column)
{
    auto &form = newForm(nullptr);
    column.addLayout(&form);
    add(form, tr("Name"), "name", Kind::Text);
    m_family = new QComboBox(this);
    m_family->setAccessibleName(tr("Family"));
    for (const Family *const family : m_families)
        m_family->addItem(tableText(family->title), qt(family->key));
    form.addRow(tr("Family"), m_family);
    add(form, tr("Firmware file"), "firmware.file", Kind::File);
    add(form, tr("Other way in"), "firmware.via", Kind::Text);
    add(form, tr("Parameter file"), "parameters.file", Kind::File);
    m_store = new QCheckBox(tr("Save them where the unit does not by itself"), this);
    connect(m_store, &QCheckBox::toggled, this, &RecipeForm::changed);
    form.addRow(m_store);
    add(form, tr("First number to give"), "number.first", Kind::Number);
}

/// A label stands above its field where there is no room beside it.
QFormLayout &RecipeForm::newForm(QWidget *parent) const
{
    auto *form = new QFormLayout(parent);
    form->setSpacing(m_theme.theme().u(8));
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    return *form;
}

QWidget *RecipeForm::buildTest()
{
    m_test = new QGroupBox(tr("Self-test: the motor turns"), this);
    m_test->setCheckable(true);
    m_test->setChecked(false);
    auto *form = &newForm(m_test);
    m_loop = new QComboBox(m_test);
    m_loop->setAccessibleName(tr("Loop"));
    form->addRow(tr("Loop"), m_loop);
    add(*form, tr("From"), "test.from", Kind::Number);
    add(*form, tr("To"), "test.to", Kind::Number);
    add(*form, tr("Time, s"), "test.time", Kind::Number);
    add(*form, tr("Repeats"), "test.repeat", Kind::Number);
    add(*form, tr("Axis"), "test.axis", Kind::Number);
    add(*form, tr("Gain slot"), "test.slot", Kind::Number);
    add(*form, tr("Travel at most, counts"), "test.limits.travel", Kind::Number);
    add(*form, tr("Speed at most, counts/s"), "test.limits.speed", Kind::Number);
    add(*form, tr("Current at most, A"), "test.limits.current", Kind::Number);
    add(*form, tr("Duty at most, 0 to 1"), "test.limits.duty", Kind::Number);
    form->addRow(buildAccept(m_test));
    connect(m_test, &QGroupBox::toggled, this, &RecipeForm::changed);
    connect(m_loop, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
        followLoop();
        Q_EMIT changed();
    });
    return m_test;
}

QWidget *RecipeForm::buildAccept(QWidget *parent)
{
    const auto keys = acceptKeys();
    m_accept = new QTableWidget(static_cast<int>(keys.size()), AcceptColumns, parent);
    m_accept->setAccessibleName(tr("What the self-test accepts"));
    m_accept->setHorizontalHeaderLabels({tr("Accepted"), tr("Least"), tr("Greatest")});
    m_accept->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_accept->verticalHeader()->hide();
    m_accept->verticalHeader()->setDefaultSectionSize(m_theme.theme().u(30));
    m_accept->setTabKeyNavigation(false);
    for (int row = 0; row < m_accept->rowCount(); ++row) {
        const std::string_view key = keys[static_cast<std::size_t>(row)];
        auto *name = new QTableWidgetItem(qt(key));
        name->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
        m_accept->setItem(row, AcceptKey, name);
        m_accept->setItem(row, AcceptLeast, new QTableWidgetItem);
        m_accept->setItem(row, AcceptGreatest, new QTableWidgetItem);
        if (key != service::figure::encoder)
            continue;
        m_accept->item(row, AcceptLeast)->setFlags(Qt::NoItemFlags);
        QTableWidgetItem &both = *m_accept->item(row, AcceptGreatest);
        both.setText(tr("counts both ways"));
        both.setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        both.setCheckState(Qt::Unchecked);
    }
    m_accept->setMinimumHeight(m_theme.theme().u(220));
    connect(m_accept, &QTableWidget::itemChanged, this, &RecipeForm::changed);
    return m_accept;
}

void RecipeForm::add(QFormLayout &form, const QString &label, const char *path, Kind kind)
{
    QLineEdit *const edit = kind == Kind::Number ? new NumberField(this) : new QLineEdit(this);
    edit->setAccessibleName(label);
    auto *name = new QLabel(label, this);
    m_fields.push_back({QLatin1String(path), kind, edit, name});
    connect(edit, &QLineEdit::textChanged, this, &RecipeForm::changed);
    if (kind != Kind::File) {
        name->setBuddy(edit);
        form.addRow(name, edit);
        return;
    }
    auto *row = new QHBoxLayout;
    auto *choose = new IconButton(m_theme, Symbol::Folder, tr("Choose: %1").arg(label), this);
    row->addWidget(edit, 1);
    row->addWidget(choose);
    form.addRow(name, row);
    connect(choose, &QToolButton::clicked, this, [this, edit] { browse(*edit); });
}

void RecipeForm::browse(QLineEdit &edit)
{
    askForFile(*this, edit.accessibleName(), {}, m_folder, [this, &edit](const QString &file) {
        const QString near = QDir(m_folder).relativeFilePath(file);
        edit.setText(m_folder.isEmpty() || near.startsWith(QLatin1String("..")) ? file : near);
    });
}

const Family *RecipeForm::family() const
{
    const int row = m_family->currentIndex(); // in their order
    return row < 0 ? nullptr : m_families[static_cast<std::size_t>(row)];
}

void RecipeForm::followFamily()
{
    const Family *const chosen = family();
    if (!chosen)
        return;
    {
        const QSignalBlocker quiet(m_loop);
        const QVariant before = m_loop->currentData();
        m_loop->clear();
        for (const Mode mode : chosen->modes)
            m_loop->addItem(modeText(mode), qt(toString(mode)));
        const QVariant wanted = before.isValid() ? before : QVariant(qt(toString(Mode::Velocity)));
        m_loop->setCurrentIndex(std::max(0, m_loop->findData(wanted)));
    }
    followLoop();
    for (const Field &field : m_fields) {
        if (field.path == QLatin1String("firmware.via"))
            field.edit->setPlaceholderText(chosen->routes.empty()
                    ? tr("none: over its own link")
                    : tr("such as %1").arg(qt(chosen->routes.front().example)));
    }
    Q_EMIT changed();
}

/// From and to are in what the loop controls.
void RecipeForm::followLoop()
{
    const Family *const chosen = family();
    if (!chosen || m_loop->currentIndex() < 0)
        return;
    const Mode mode = chosen->modes[static_cast<std::size_t>(m_loop->currentIndex())]; // in their order
    const QString unit = mode == Mode::Duty ? tr("0 to 1") : shownUnit(mode, {}).text;
    for (const Field &field : m_fields) {
        if (field.path != QLatin1String("test.from") && field.path != QLatin1String("test.to"))
            continue;
        field.label->setText(unit.isEmpty() ? field.edit->accessibleName()
                                            : tr("%1, %2", "field, unit").arg(field.edit->accessibleName(), unit));
        field.edit->setAccessibleDescription(unit);
    }
}

bool RecipeForm::isYesOrNo(int row) const
{
    return m_accept->item(row, AcceptKey)->text() == qt(service::figure::encoder);
}

QJsonValue RecipeForm::accepted(int row) const
{
    const QTableWidgetItem &greatest = *m_accept->item(row, AcceptGreatest);
    if (isYesOrNo(row))
        return greatest.checkState() == Qt::Checked ? QJsonValue(true) : QJsonValue(QJsonValue::Undefined);
    const QString least = m_accept->item(row, AcceptLeast)->text().trimmed();
    const QString most = greatest.text().trimmed();
    if (least.isEmpty())
        return most.isEmpty() ? QJsonValue(QJsonValue::Undefined) : numberOf(most);
    QJsonArray both{numberOf(least)};
    if (!most.isEmpty())
        both.append(numberOf(most));
    return both;
}

void RecipeForm::accept(int row, const QJsonValue &value)
{
    QTableWidgetItem &greatest = *m_accept->item(row, AcceptGreatest);
    if (isYesOrNo(row))
        return greatest.setCheckState(value.toBool() ? Qt::Checked : Qt::Unchecked);
    const QJsonArray both = value.toArray();
    m_accept->item(row, AcceptLeast)->setText(wordOf(both.at(0)));
    greatest.setText(wordOf(both.isEmpty() ? value : both.at(1)));
}

QByteArray RecipeForm::text() const
{
    QJsonObject recipe{{QStringLiteral("recipe"), 1}, {QStringLiteral("name"), QString()},
        {QStringLiteral("family"), m_family->currentData().toString()}};
    const bool tested = m_test->isChecked();
    for (const Field &field : m_fields) {
        const QString typed = field.edit->text().trimmed();
        if (typed.isEmpty() || (field.path.startsWith(QLatin1String("test.")) && !tested))
            continue;
        put(recipe, field.path.split(QLatin1Char('.')), 0,
            field.kind == Kind::Number ? numberOf(typed) : QJsonValue(typed));
    }
    if (m_store->isChecked())
        put(recipe, {QStringLiteral("parameters"), QStringLiteral("store")}, 0, true);
    if (!tested)
        return QJsonDocument(recipe).toJson(QJsonDocument::Indented);
    put(recipe, {QStringLiteral("test"), QStringLiteral("loop")}, 0, m_loop->currentData().toString());
    for (int row = 0; row < m_accept->rowCount(); ++row) {
        const QJsonValue value = accepted(row);
        if (!value.isUndefined())
            put(recipe, {QStringLiteral("test"), QStringLiteral("accept"), m_accept->item(row, AcceptKey)->text()}, 0,
                value);
    }
    return QJsonDocument(recipe).toJson(QJsonDocument::Indented);
}

void RecipeForm::setText(const QByteArray &recipe)
{
    const QJsonObject object = QJsonDocument::fromJson(recipe).object();
    {
        const QSignalBlocker quiet(this);
        m_family->setCurrentIndex(m_family->findData(at(object, QStringLiteral("family")).toString()));
        for (const Field &field : m_fields)
            field.edit->setText(wordOf(at(object, field.path)));
        m_store->setChecked(at(object, QStringLiteral("parameters.store")).toBool());
        m_test->setChecked(object.contains(QLatin1String("test")));
        m_loop->setCurrentIndex(std::max(0, m_loop->findData(at(object, QStringLiteral("test.loop")).toString())));
        const QJsonObject limits = at(object, QStringLiteral("test.accept")).toObject();
        for (int row = 0; row < m_accept->rowCount(); ++row)
            accept(row, limits.value(m_accept->item(row, AcceptKey)->text()));
    }
    Q_EMIT changed();
}

} // namespace mb
