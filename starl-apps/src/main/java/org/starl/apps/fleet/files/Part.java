package org.starl.apps.fleet.files;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.input.Field;
import org.starl.input.Form;
import org.starl.input.Node;

/**
 * A part of a YAML document, with its place for errors.
 *
 * @param path the keys above it, as in {@code levels.L1.lanes[2]}; empty for the whole document
 */
record Part(String file, String path, Node node) {

  /**
   * Whether this mapping has a value for the key; null, {@code ""}, {@code []} and {@code {}} are none, and may
   * stand for a mapping.
   */
  boolean has(String key) {
    if (node instanceof Node.Mapping mapping) {
      return !isNone(mapping.parts().get(key));
    }
    if (!isNone(node)) {
      throw wrong("a mapping");
    }
    return false;
  }

  private static boolean isNone(@Nullable Node node) {
    return switch (node) {
      case null -> true;
      case Node.Text text -> text.value().isBlank();
      case Node.Listing list -> list.items().isEmpty();
      case Node.Mapping beneath -> beneath.parts().isEmpty();
    };
  }

  Set<String> keys() {
    if (node instanceof Node.Mapping mapping) {
      return mapping.parts().keySet();
    }
    throw wrong("a mapping");
  }

  /** @param expected the form of the value, for errors */
  Part at(String key, String expected) {
    Node beneath = node instanceof Node.Mapping mapping ? mapping.parts().get(key) : null;
    if (beneath == null) {
      String prefix = path.isEmpty() ? "" : path + ": ";
      throw BadInput.at(file, node.line(), prefix + "has no '" + key + ":'; expected " + expected);
    }
    return new Part(file, path.isEmpty() ? key : path + "." + key, beneath);
  }

  /** The items of the list at {@code key}; none if the key or its value is missing. */
  List<Part> list(String key) {
    return has(key) ? at(key, "a list").items(0, "a list") : List.of();
  }

  /** The items of this list, at least {@code least}. */
  List<Part> items(int least, String expected) {
    if (!(node instanceof Node.Listing list) || list.items().size() < least) {
      throw wrong(expected);
    }
    List<Part> items = new ArrayList<>();
    for (Node item : list.items()) {
      items.add(new Part(file, path + "[" + items.size() + "]", item));
    }
    return items;
  }

  String text() {
    if (node instanceof Node.Text text) {
      return text.value().trim();
    }
    throw wrong("one value");
  }

  /** The value of a field, whose key does not matter. */
  <T> T as(Field<T> field) {
    T value = field.reader().apply(text());
    if (value == null) {
      throw wrong(Form.expected(field.form()));
    }
    return value;
  }

  BadInput wrong(String expected) {
    String prefix = path.isEmpty() ? "" : path + ": ";
    return BadInput.at(file, node.line(), prefix + node.shown() + ": expected " + expected);
  }
}
