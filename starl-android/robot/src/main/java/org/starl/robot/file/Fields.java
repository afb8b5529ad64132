package org.starl.robot.file;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/** The parts of a mapping, each of which is to be read; {@link #end} refuses what nobody has read. */
final class Fields {

  private static final Pattern NUMBER =
      Pattern.compile("[-+]?(\\d+\\.?\\d*|\\.\\d+)([eE][-+]?\\d+)?");
  private static final String A_LIST = "a list";
  private static final Pattern PORT = Pattern.compile("[1-9]\\d{0,4}");

  private final String file;
  private final String path;
  private final Node.Mapping mapping;
  private final Set<String> known = new TreeSet<>();

  private Fields(String file, String path, Node.Mapping mapping) {
    this.file = file;
    this.path = path;
    this.mapping = mapping;
  }

  /** @param path what the mapping is called in the file, empty for the whole of it */
  static Fields of(String file, String path, Node node, String expected) {
    if (node instanceof Node.Mapping mapping) {
      return new Fields(file, path, mapping);
    }
    String what = node instanceof Node.Text text ? "'" + text.value() + "'" : A_LIST;
    throw new DeploymentException(
        file + ":" + node.line() + ": " + path + ": " + what + ": expected " + expected);
  }

  Map<String, Node> parts() {
    return mapping.parts();
  }

  int line() {
    return mapping.line();
  }

  int line(String key) {
    Node node = mapping.parts().get(key);
    return node == null ? line() : node.line();
  }

  @Nullable Fields linesOrNull(Field field) {
    Node node = part(field.key());
    return node == null ? null : of(file, name(field.key()), node, expected(field.form()));
  }

  /** What stands beneath; where nothing does, as if nothing did. */
  Fields linesOrNone(Field field) {
    Fields fields = linesOrNull(field);
    return fields == null
        ? new Fields(file, name(field.key()), new Node.Mapping(line(), Map.of()))
        : fields;
  }

  Fields lines(Field field) {
    Fields fields = linesOrNull(field);
    if (fields == null) {
      throw lacking(field);
    }
    return fields;
  }

  /** The parts beneath the robot of that name. */
  Fields lines(String name, Form.Lines form) {
    return lines(Field.needed(name, form, ""));
  }

  /** The one value that stands at a key that no field is called like. */
  String value(String key) {
    return text(Field.needed(key, new Form.Text("one value"), ""));
  }

  @Nullable String textOrNull(Field field) {
    return switch (part(field.key())) {
      case Node.Text text when !text.value().trim().isEmpty() -> text.value().trim();
      case null -> field.usual();
      case Node.Listing list ->
          throw new DeploymentException(
              file
                  + ":"
                  + list.line()
                  + ": "
                  + name(field.key())
                  + ": "
                  + A_LIST
                  + ": expected "
                  + expected(field.form()));
      default -> throw wrong(field.key(), "", expected(field.form()));
    };
  }

  String text(Field field) {
    String text = textOrNull(field);
    if (text == null) {
      throw lacking(field);
    }
    return text;
  }

  String choice(Field field) {
    String text = text(field);
    if (!((Form.Choice) field.form()).values().contains(text)) {
      throw wrong(field.key(), text, expected(field.form()));
    }
    return text;
  }

  boolean yesNo(Field field) {
    String text = text(field);
    return switch (text) {
      case "true", "yes" -> true;
      case "false", "no" -> false;
      default -> throw wrong(field.key(), text, expected(field.form()));
    };
  }

  int whole(Field field) {
    return Math.toIntExact(wholeLong(field));
  }

  /** @param usual where there is no such part */
  int wholeOr(Field field, int usual) {
    return part(field.key()) == null ? usual : whole(field);
  }

  long wholeLong(Field field) {
    Form.Whole form = (Form.Whole) field.form();
    String text = text(field);
    try {
      long value = Long.parseLong(text);
      if (value >= form.least() && value <= form.most()) {
        return value;
      }
    } catch (NumberFormatException e) {
      throw wrong(field.key(), text, expected(form));
    }
    throw wrong(field.key(), text, expected(form));
  }

  double amount(Field field) {
    Form.Amount form = (Form.Amount) field.form();
    String text = text(field);
    // Double.parseDouble takes more: 0x1p3, 5d, NaN.
    if (NUMBER.matcher(text).matches()) {
      double value = Double.parseDouble(text);
      if (value >= form.least() && value <= form.most()) {
        return value;
      }
    }
    throw wrong(field.key(), text, expected(form));
  }

  /** @param usualPort where the text names none, and need not */
  @Nullable HostPort addressOrNull(Field field, int usualPort) {
    String text = textOrNull(field);
    return text == null
        ? null
        : address(field.key(), text, ((Form.Address) field.form()).needsPort() ? 0 : usualPort);
  }

  /** @param usualPort where the text names none; 0 where it must */
  HostPort address(String key, String text, int usualPort) {
    String expected = usualPort == 0 ? "HOST:PORT" : "HOST or HOST:PORT";
    int colon = text.lastIndexOf(':');
    boolean hasPort = colon >= 0 && (text.indexOf(':') == colon || text.charAt(colon - 1) == ']');
    String host = hasPort ? text.substring(0, colon) : text;
    if (host.startsWith("[") && host.endsWith("]")) {
      host = host.substring(1, host.length() - 1);
    }
    int port = usualPort;
    if (hasPort) {
      String digits = text.substring(colon + 1);
      port = PORT.matcher(digits).matches() ? Integer.parseInt(digits) : 0;
    }
    if (host.isEmpty() || host.indexOf(' ') >= 0 || port < 1 || port > HostPort.MAX_PORT) {
      throw wrong(key, text, expected);
    }
    return new HostPort(host, port);
  }

  /** Everything is read. */
  void end() {
    for (Map.Entry<String, Node> part : mapping.parts().entrySet()) {
      if (!known.contains(part.getKey())) {
        throw new DeploymentException(
            file
                + ":"
                + part.getValue().line()
                + ": "
                + (path.isEmpty() ? "" : path + ": ")
                + "'"
                + part.getKey()
                + "': expected one of "
                + List.copyOf(known));
      }
    }
  }

  DeploymentException wrong(String key, String value, String expected) {
    return new DeploymentException(
        file + ":" + line(key) + ": " + name(key) + ": '" + value + "': expected " + expected);
  }

  DeploymentException lacking(Field field) {
    return lacking(field.key(), expected(field.form()));
  }

  DeploymentException lacking(String key, String expected) {
    return new DeploymentException(
        file
            + ":"
            + line()
            + ": "
            + (path.isEmpty() ? "" : path + ": ")
            + "has no '"
            + key
            + ":'; expected "
            + expected);
  }

  private static String expected(Form form) {
    return switch (form) {
      case Form.Text text -> text.expected();
      case Form.Choice choice -> "one of " + String.join(", ", choice.values());
      case Form.YesNo yesNo -> "one of true, false, yes, no";
      case Form.Whole whole -> "a whole number from " + whole.least() + " to " + whole.most();
      case Form.Amount amount -> "a number from " + amount.least() + " to " + amount.most();
      case Form.Address address -> address.needsPort() ? "HOST:PORT" : "HOST or HOST:PORT";
      case Form.Port port -> "a device or tcp:HOST:PORT";
      case Form.Lines lines -> lines.expected();
      case Form.Kinds kinds -> kinds.expected();
      case Form.Named named -> named.expected();
      case Form.Parameters parameters -> parameters.expected();
    };
  }

  private @Nullable Node part(String key) {
    known.add(key);
    return mapping.parts().get(key);
  }

  private String name(String key) {
    return path.isEmpty() ? key : path + "." + key;
  }
}
