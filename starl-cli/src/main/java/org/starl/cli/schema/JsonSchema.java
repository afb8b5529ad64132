package org.starl.cli.schema;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.starl.cli.command.Json;
import org.starl.input.Field;
import org.starl.input.Form;
import org.starl.input.Quantity;
import org.starl.robot.file.Wheels;
import org.starl.sim.fault.FaultGrammar;

/** Builds JSON schemas (draft 7) from {@link Form}s. A schema is a map, ready to print as JSON. */
final class JsonSchema {

  static final String DESCRIPTION = "description";
  static final String PROPERTIES = "properties";
  static final String REQUIRED = "required";
  static final List<Object> YES_NO = List.of(true, false, "yes", "no", "on", "off");

  private static final String TYPE = "type";
  private static final String PATTERN = "pattern";
  private static final String PATTERN_MESSAGE = "patternErrorMessage";

  private static final String PORT_NUMBER =
      "(6553[0-5]|655[0-2]\\d|65[0-4]\\d\\d|6[0-4]\\d{3}|[1-5]\\d{4}|[1-9]\\d{0,3})";
  private static final String BRACKETS = "\\[[^\\s\\[\\]]+\\]";
  private static final String HOST_PORT = "(" + Form.HOST + "|" + BRACKETS + "):" + PORT_NUMBER;

  /** As the reader has it: an address whose {@code tcp:} is missing. */
  private static final String NO_DEVICE = Wheels.Port.HOST_AND_PORT.pattern();

  /** An IPv6 address needs no brackets where no port follows. */
  private static final String HOST =
      "(" + Form.HOST + "|" + BRACKETS + "|[^\\s:\\[\\]]*(:[^\\s:\\[\\]]*){2,})";

  /** A text. YAML reads text without quotes as a number or a boolean, if it looks like one. */
  private static final List<String> ANY_TEXT = List.of("string", "number", "boolean");

  private JsonSchema() {}

  /** The first fields of a schema file. */
  static Map<String, Object> document(String title, String meaning) {
    String draft = "http://json-schema.org/draft-07/schema#";
    return Json.object("$schema", draft, "title", title, DESCRIPTION, meaning);
  }

  /** A value with its meaning and default. */
  static Map<String, Object> property(String meaning, Form form, @Nullable String defaultText) {
    Map<String, Object> json = Json.object(DESCRIPTION, meaning);
    json.putAll(value(form));
    putDefault(json, form, defaultText);
    return json;
  }

  /** Adds the default value with its YAML type. */
  static void putDefault(Map<String, Object> json, Form form, @Nullable String text) {
    if (text != null) {
      json.put("default", typed(form, text));
    }
  }

  /** A mapping with these fields and no others. */
  static Map<String, Object> mapping(List<Field<?>> fields) {
    List<String> needed = fields.stream().filter(Field::isNeeded).map(Field::key).toList();
    Map<String, Object> json = Json.object(TYPE, "object", "additionalProperties", false);
    json.putAll(Json.object(REQUIRED, needed, PROPERTIES, properties(fields)));
    return json;
  }

  static Map<String, Object> properties(List<Field<?>> fields) {
    Map<String, Object> json = new LinkedHashMap<>();
    for (Field<?> field : fields) {
      json.put(field.key(), property(field.meaning(), field.form(), field.defaultText()));
    }
    return json;
  }

  static Map<String, Object> value(Form form) {
    return switch (form) {
      case Form.Whole whole -> number("integer", whole.least(), whole.most());
      case Form.Decimal decimal -> number("number", decimal.least(), decimal.most());
      case Form.Amount amount -> amount(amount);
      case Form.Between between -> between(between);
      case Form.Choice choice -> Map.of("enum", choices(choice));
      case Form.YesNo yesNo -> Map.of("enum", YES_NO);
      case Form.Text text ->
          text.pattern().isEmpty() ? Json.object(TYPE, ANY_TEXT) : text(text.pattern());
      case Form.Words words ->
          words.pattern().equals(Form.Words.ANY)
              ? Json.object(TYPE, ANY_TEXT, PATTERN, words.pattern())
              : text(words.pattern());
      case Form.Faults faults -> faults();
      case Form.Address address ->
          text(address, address.needsPort() ? HOST_PORT : "(" + HOST_PORT + "|" + HOST + ")");
      case Form.Port port -> text(port, "(tcp:" + HOST_PORT + "|(?!tcp:|" + NO_DEVICE + "$)\\S.*)");
      case Form.Lines lines -> mapping(lines.fields());
      case Form.Kinds kinds -> kinds(kinds);
      case Form.Named named -> named(named);
      case Form.Parameters parameters -> ScenarioSchema.anyParameters();
    };
  }

  private static Map<String, Object> text(String pattern) {
    return Json.object(TYPE, "string", PATTERN, pattern);
  }

  private static Map<String, Object> text(Form form, String pattern) {
    Map<String, Object> json = text("^\\s*" + pattern + "\\s*$");
    json.put(PATTERN_MESSAGE, "expected " + Form.expected(form));
    return json;
  }

  private static Map<String, Object> number(String type, Number least, Number most) {
    return Json.object(TYPE, type, "minimum", least, "maximum", most);
  }

  private static Map<String, Object> between(Form.Between between) {
    Quantity quantity = between.quantity();
    Map<String, Object> json = amount(new Form.Amount(quantity, false));
    json.replace("minimum", quantity.value(between.least()));
    json.replace("maximum", quantity.value(between.most()));
    return json;
  }

  private static Map<String, Object> amount(Form.Amount amount) {
    Quantity quantity = amount.quantity();
    double most = quantity.mostWithoutUnit();
    boolean takesNumbers = amount.isAboveZero() ? most > 0 : most >= 0;
    Map<String, Object> json = Json.object(TYPE, "number");
    if (!isPlainNumber(amount)) {
      json.put(TYPE, takesNumbers ? List.of("number", "string") : "string");
      json.put(PATTERN, amount.isAboveZero() ? quantity.patternAbove0() : quantity.pattern());
    }
    if (takesNumbers) {
      json.put(amount.isAboveZero() ? "exclusiveMinimum" : "minimum", 0);
      if (most < Double.POSITIVE_INFINITY) {
        json.put("maximum", (long) most);
      }
    }
    return json;
  }

  // YAML reads a version such as 4.1 as a number, unless it is quoted.
  private static List<Object> choices(Form.Choice choice) {
    List<Object> values = new ArrayList<>(choice.values());
    for (String value : choice.values()) {
      if (value.matches("\\d+\\.\\d+")) {
        values.add(Double.valueOf(value));
      }
    }
    return values;
  }

  // Each kind has its own fields and no others.
  private static Map<String, Object> kinds(Form.Kinds kinds) {
    List<Object> rules = new ArrayList<>();
    kinds
        .kinds()
        .forEach((kind, fields) -> {
          List<Field<?>> all = new ArrayList<>(List.of(kinds.by()));
          all.addAll(fields);
          String by = kinds.by().key();
          Map<String, Object> isKind = Json.object(PROPERTIES, Map.of(by, Map.of("const", kind)));
          if (!kind.equals(kinds.by().defaultText())) {
            isKind.put(REQUIRED, List.of(by));
          }
          rules.add(Json.object("if", isKind, "then", mapping(all)));
        });
    List<String> needed = kinds.by().isNeeded() ? List.of(kinds.by().key()) : List.of();
    Map<String, Object> json = Json.object(TYPE, "object", REQUIRED, needed);
    json.putAll(Json.object(PROPERTIES, properties(List.of(kinds.by())), "allOf", rules));
    return json;
  }

  private static Map<String, Object> named(Form.Named named) {
    Map<String, Object> json = Json.object(TYPE, "object", "minProperties", 1);
    json.put("propertyNames", Map.of(PATTERN, "^(?!.*\\.[0-9]+$)[A-Za-z][A-Za-z0-9_.-]{0,31}$"));
    json.put("additionalProperties", value(named.each()));
    return json;
  }

  // A text or a list. YAML splits the list [loss(0.1,from=bot1)] at each comma. So the list may
  // also have the rest of a fault, such as "from=bot1)".
  private static Map<String, Object> faults() {
    List<String> usages = new ArrayList<>();
    List<String> names = new ArrayList<>();
    for (FaultGrammar.Kind kind : FaultGrammar.kinds()) {
      usages.add(kind.usage() + ": " + kind.meaning());
      names.add(kind.name());
    }
    String begin = "\\s*(" + String.join("|", names) + ")\\s*(\\(.*)?$";
    String part = "^(" + begin + "|\\s*[a-z]+\\s*=.*|\\s*[-+0-9].*)";
    Map<String, Object> item = Json.object(TYPE, List.of("string", "number"), PATTERN, part);
    item.put(PATTERN_MESSAGE, "expected a fault: " + String.join(", ", names));
    Map<String, Object> text = text("^(\\s*$|" + begin + ")");
    text.put(PATTERN_MESSAGE, "expected faults: " + String.join(", ", names));
    String meaning =
        "the faults to inject, one per line; %s:\n%s"
            .formatted(FaultGrammar.TIMES, String.join("\n", usages));
    List<Object> forms = List.of(Json.object(TYPE, "array", "items", item), text);
    return Json.object(DESCRIPTION, meaning, "anyOf", forms);
  }

  private static boolean isPlainNumber(Form form) {
    return form instanceof Form.Amount amount
        && (amount.quantity() == Quantity.NUMBER || amount.quantity() == Quantity.PROBABILITY);
  }

  private static Object typed(Form form, String text) {
    return switch (form) {
      case Form.Whole whole -> Long.valueOf(text);
      case Form.Decimal decimal -> Double.valueOf(text);
      case Form.YesNo yesNo -> text.equals("yes") || Boolean.parseBoolean(text);
      case Form.Amount amount when isPlainNumber(amount) -> Double.valueOf(text);
      default -> text;
    };
  }
}
