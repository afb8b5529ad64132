package org.starl.cli.mutants;

import java.io.IOException;
import java.io.OutputStream;
import java.lang.instrument.ClassDefinition;
import java.lang.instrument.Instrumentation;
import java.lang.instrument.UnmodifiableClassException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.jar.Attributes;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import org.jspecify.annotations.Nullable;

/** Redefines classes: the JVM gives this class the means for it, as its jar's manifest asks. */
public final class Agent {

  private static @Nullable Instrumentation instrumentation;

  private Agent() {}

  /** The JVM calls this before {@code main}. */
  public static void premain(@Nullable String options, Instrumentation given) {
    instrumentation = given;
  }

  /** Writes a jar that names this class, and has no class. */
  static void writeJar(Path file) throws IOException {
    Manifest manifest = new Manifest();
    Attributes attributes = manifest.getMainAttributes();
    attributes.put(Attributes.Name.MANIFEST_VERSION, "1.0");
    attributes.putValue("Premain-Class", Agent.class.getName());
    attributes.putValue("Can-Redefine-Classes", "true");
    try (OutputStream out = Files.newOutputStream(file)) {
      new JarOutputStream(out, manifest).close();
    }
  }

  /**
   * Gives classes other bodies of methods.
   *
   * @throws UnsupportedOperationException if the JVM refuses the change, as for some records
   * @throws LinkageError if the JVM refuses the bytes
   */
  static void redefine(Map<String, byte[]> classes) {
    if (instrumentation == null) {
      throw new IllegalStateException("this process has no agent");
    }
    List<ClassDefinition> definitions = new ArrayList<>();
    try {
      for (Map.Entry<String, byte[]> one : classes.entrySet()) {
        ClassLoader loader = Agent.class.getClassLoader();
        Class<?> loaded = Class.forName(one.getKey(), false, loader);
        definitions.add(new ClassDefinition(loaded, one.getValue()));
      }
      instrumentation.redefineClasses(definitions.toArray(new ClassDefinition[0]));
    } catch (ClassNotFoundException | UnmodifiableClassException e) {
      throw new UnsupportedOperationException(e);
    }
  }
}
