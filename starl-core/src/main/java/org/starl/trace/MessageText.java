package org.starl.trace;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Reads the text of a message in a trace: that of a record, {@code Ok[from=bot1#1, num=2]}. So a
 * monitor can compare what robots tell each other with what they do. Only for messages whose fields
 * are records, lists, numbers and names.
 */
public final class MessageText {

  private MessageText() {}

  /** The type of a record, such as {@code Ok}; a text without fields is returned whole. */
  public static String type(String message) {
    int end = message.indexOf('[');
    return end < 0 ? message : message.substring(0, end);
  }

  /** Whether {@code message} is a record of this type, as in {@code Ok}. */
  public static boolean isA(String type, String message) {
    return message.startsWith(type) && message.startsWith("[", type.length());
  }

  /**
   * The text of a field.
   *
   * @throws IllegalArgumentException if the message has no such field
   */
  public static String field(String message, String name) {
    String found = fieldOrNull(message, name);
    if (found == null) {
      throw new IllegalArgumentException("message '" + message + "': expected a field " + name);
    }
    return found;
  }

  // Monitors read most messages field by field: this makes no list of the others.
  private static @Nullable String fieldOrNull(String message, String name) {
    int from = first(message);
    for (int end = end(message, from); end >= 0; end = end(message, from)) {
      if (message.startsWith(name, from) && message.startsWith("=", from + name.length())) {
        return message.substring(from + name.length() + 1, end);
      }
      from = end + 2;
    }
    return null;
  }

  /** The elements of a list, {@code [a, b]}, or the fields of a record with their names. */
  public static List<String> parts(String text) {
    List<String> parts = new ArrayList<>();
    int from = first(text);
    for (int end = end(text, from); end >= 0; end = end(text, from)) {
      if (end > from) {
        parts.add(text.substring(from, end));
      }
      from = end + 2;
    }
    return parts;
  }

  private static int first(String text) {
    return text.indexOf('[') + 1;
  }

  /** The end of the element that begins at {@code from}; negative if there is none. */
  private static int end(String text, int from) {
    int depth = 0;
    for (int i = from; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c == '[') {
        depth++;
      } else if (depth > 0 && c == ']') {
        depth--;
      } else if (depth == 0 && (c == ']' || text.startsWith(", ", i))) {
        return i;
      }
    }
    return -1;
  }
}
