package org.starl.input;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;

/** Reads the fields of one mapping of a document; {@link #end} refuses keys that were not read. */
public final class Section {

  private final String file;
  private final String path;
  private final Node.Mapping mapping;
  private final Set<String> known = new TreeSet<>();

  private Section(String file, String path, Node.Mapping mapping) {
    this.file = file;
    this.path = path;
    this.mapping = mapping;
  }

  /**
   * The whole of a document.
   *
   * @param file its name, for messages
   */
  public static Section of(String file, Node.Mapping document) {
    return new Section(file, "", document);
  }

  /** Every key, in the document's order. */
  public Set<String> keys() {
    return mapping.parts().keySet();
  }

  /** The line of the key; the mapping's own if it does not have the key. */
  public int line(String key) {
    Node node = mapping.parts().get(key);
    return node == null ? mapping.line() : node.line();
  }

  /** The field's value or its default. */
  public <T> T get(Field<T> field) {
    T value = getOrNull(field);
    if (value == null) {
      throw missing(field.key(), Form.expected(field.form()));
    }
    return value;
  }

  /** The same; null if the line is missing and the field has no default. */
  public <T> @Nullable T getOrNull(Field<T> field) {
    String text = text(field);
    if (text == null) {
      return null;
    }
    T value = field.reader().apply(text);
    if (value == null) {
      throw wrong(field.key(), text, Form.expected(field.form()));
    }
    return value;
  }

  /** The mapping of the field; an empty one if the line is missing and not needed. */
  public Section section(Field<Void> field) {
    Node node = part(field.key());
    if (node == null && field.isNeeded()) {
      throw missing(field.key(), Form.expected(field.form()));
    }
    if (node == null) {
      return new Section(file, name(field.key()), new Node.Mapping(mapping.line(), Map.of()));
    }
    if (node instanceof Node.Mapping beneath) {
      return new Section(file, name(field.key()), beneath);
    }
    throw wrong(field, node);
  }

  /** Refuses keys that were not read before. */
  public void end() {
    mapping
        .parts()
        .forEach((key, node) -> {
          if (!known.contains(key)) {
            throw error(
                node.line(), prefix() + "'" + key + "': expected one of " + List.copyOf(known));
          }
        });
  }

  public BadInput wrong(String key, String value, String expected) {
    return error(line(key), name(key) + ": '" + value + "': expected " + expected);
  }

  public BadInput missing(String key, String expected) {
    return error(mapping.line(), prefix() + "has no '" + key + ":'; expected " + expected);
  }

  private @Nullable String text(Field<?> field) {
    return switch (part(field.key())) {
      case Node.Text text when !text.value().trim().isEmpty() -> text.value().trim();
      case null -> field.defaultText();
      case Node node -> throw wrong(field, node);
    };
  }

  private BadInput wrong(Field<?> field, Node node) {
    String expected = Form.expected(field.form());
    return error(node.line(), name(field.key()) + ": " + node.shown() + ": expected " + expected);
  }

  private @Nullable Node part(String key) {
    known.add(key);
    return mapping.parts().get(key);
  }

  private String name(String key) {
    return path.isEmpty() ? key : path + "." + key;
  }

  private String prefix() {
    return path.isEmpty() ? "" : path + ": ";
  }

  private BadInput error(int line, String text) {
    return BadInput.at(file, line, text);
  }
}
