package org.starl.lang.read;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Primitive;

/** StarL's own automata, and how programs use them: sources in this module. */
final class Library {

  /** The source of the primitives. */
  static final String PRIMITIVES = "primitives.starl";

  private final Map<String, Source> read = new LinkedHashMap<>();

  /** StarL's primitives. */
  List<Primitive> primitives() {
    return source(PRIMITIVES).map(Source::primitives).orElseThrow();
  }

  /** StarL's automaton of this name. */
  Optional<Automaton> automaton(String name) {
    return source("library/" + name + ".starl")
        .flatMap(source -> source.automata().stream().findFirst());
  }

  private Optional<Source> source(String file) {
    Source known = read.get(file);
    if (known == null) {
      String text = text(file);
      if (text == null) {
        return Optional.empty();
      }
      known = new SourceReader(this).look(file, text, null);
      if (!known.errors().isEmpty()) {
        throw new IllegalStateException(known.errors().toString());
      }
      read.put(file, known);
    }
    return Optional.of(known);
  }

  private static @Nullable String text(String file) {
    try (InputStream in = Library.class.getResourceAsStream("/org/starl/lang/" + file)) {
      return in == null ? null : new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
