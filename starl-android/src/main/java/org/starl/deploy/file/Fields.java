package org.starl.deploy.file;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;

/** The parts of a mapping, each of which is to be read; {@link #end} refuses what nobody has read. */
final class Fields {

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
    Node.Text text = (Node.Text) node;
    throw new DeploymentException(
        file + ":" + node.line() + ": " + path + ": '" + text.value() + "': expected " + expected);
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

  @Nullable Fields mappingOrNull(String key, String expected) {
    Node node = part(key);
    return node == null ? null : of(file, name(key), node, expected);
  }

  Fields mapping(String key, String expected) {
    Fields fields = mappingOrNull(key, expected);
    if (fields == null) {
      throw lacking(key, expected);
    }
    return fields;
  }

  @Nullable String textOrNull(String key, String expected) {
    return switch (part(key)) {
      case Node.Text text when !text.value().trim().isEmpty() -> text.value().trim();
      case null -> null;
      default -> throw wrong(key, "", expected);
    };
  }

  String text(String key, String expected) {
    String text = textOrNull(key, expected);
    if (text == null) {
      throw lacking(key, expected);
    }
    return text;
  }

  String choice(String key, @Nullable String usual, String... values) {
    String expected = "expected one of " + String.join(", ", values);
    String text = textOrNull(key, expected.substring("expected ".length()));
    if (text == null && usual != null) {
      return usual;
    }
    if (text == null) {
      throw lacking(key, expected.substring("expected ".length()));
    }
    if (!Arrays.asList(values).contains(text)) {
      throw wrong(key, text, expected.substring("expected ".length()));
    }
    return text;
  }

  boolean yesNo(String key, boolean usual) {
    return switch (choice(key, usual ? "true" : "false", "true", "false", "yes", "no")) {
      case "true", "yes" -> true;
      default -> false;
    };
  }

  int whole(String key, @Nullable Integer usual, int least, int most) {
    return (int) wholeLong(key, usual == null ? null : (long) usual, least, most);
  }

  long wholeLong(String key, @Nullable Long usual, long least, long most) {
    String expected = "a whole number from " + least + " to " + most;
    String text = textOrNull(key, expected);
    if (text == null) {
      if (usual == null) {
        throw lacking(key, expected);
      }
      return usual;
    }
    try {
      long value = Long.parseLong(text);
      if (value >= least && value <= most) {
        return value;
      }
    } catch (NumberFormatException e) {
      throw wrong(key, text, expected);
    }
    throw wrong(key, text, expected);
  }

  double number(String key, double usual, double least, double most) {
    String expected = "a number from " + least + " to " + most;
    String text = textOrNull(key, expected);
    if (text == null) {
      return usual;
    }
    try {
      double value = Double.parseDouble(text);
      if (value >= least && value <= most) {
        return value;
      }
    } catch (NumberFormatException e) {
      throw wrong(key, text, expected);
    }
    throw wrong(key, text, expected);
  }

  @Nullable HostPort addressOrNull(String key, int usualPort) {
    String text = textOrNull(key, "HOST or HOST:PORT");
    return text == null ? null : address(key, text, usualPort);
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
      port = digits.matches("\\d{1,5}") ? Integer.parseInt(digits) : 0;
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

  private @Nullable Node part(String key) {
    known.add(key);
    return mapping.parts().get(key);
  }

  private String name(String key) {
    return path.isEmpty() ? key : path + "." + key;
  }
}
