package org.starl.input;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** A part of a document: one text, a list or a mapping, with its first line, from 1. */
public sealed interface Node {

  int line();

  /** What stands there, for messages. */
  default String shown() {
    return switch (this) {
      case Text text -> BadInput.quote(text.value());
      case Listing list -> "a list of " + list.items().size();
      case Mapping mapping -> "a mapping";
    };
  }

  /** One value, as it is written; empty for YAML's null. */
  record Text(int line, String value) implements Node {}

  /** A list, in the document's order. */
  record Listing(int line, List<Node> items) implements Node {
    public Listing {
      items = Collections.unmodifiableList(new ArrayList<>(items));
    }
  }

  /** Parts by their keys, in the document's order. */
  record Mapping(int line, Map<String, Node> parts) implements Node {
    public Mapping {
      parts = Collections.unmodifiableMap(new LinkedHashMap<>(parts));
    }
  }
}
