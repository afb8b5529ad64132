package org.starl.robot.file;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** A part of a file: one text, a list, or parts by name; with the line on which it begins, from 1. */
public sealed interface Node {

  int line();

  /** One value, as it is written. */
  record Text(int line, String value) implements Node {}

  /** Parts without names, in the file's order. */
  record Listing(int line, List<Node> items) implements Node {
    public Listing {
      items = Collections.unmodifiableList(new ArrayList<>(items));
    }
  }

  /** Parts by name, in the file's order. */
  record Mapping(int line, Map<String, Node> parts) implements Node {
    public Mapping {
      parts = Collections.unmodifiableMap(new LinkedHashMap<>(parts));
    }
  }
}
