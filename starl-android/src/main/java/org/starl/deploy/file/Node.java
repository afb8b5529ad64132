package org.starl.deploy.file;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/** A part of a file that is one text, or parts by name; with the line on which it begins, from 1. */
public sealed interface Node {

  int line();

  /** One value, as it is written. */
  record Text(int line, String value) implements Node {}

  /** Parts by name, in the file's order. */
  record Mapping(int line, Map<String, Node> parts) implements Node {
    public Mapping {
      parts = Collections.unmodifiableMap(new LinkedHashMap<>(parts));
    }
  }
}
