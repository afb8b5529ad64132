package org.starl.cli.mutants;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.pitest.classinfo.ClassName;
import org.pitest.classpath.ClassPath;
import org.pitest.classpath.ClassPathByteArraySource;
import org.pitest.mutationtest.EngineArguments;
import org.pitest.mutationtest.engine.Mutater;
import org.pitest.mutationtest.engine.MutationDetails;
import org.pitest.mutationtest.engine.gregor.config.GregorEngineFactory;
import org.starl.input.BadInput;

/** The bugs that can be planted in some classes of the class path, in an order that depends on those classes alone. */
final class Bugs {

  /** What no run calls, and a static initializer that has run. */
  private static final List<String> LEFT_OUT = List.of("toString", "hashCode", "<clinit>");

  private final ClassPath path = new ClassPath();
  private final SortedSet<String> classes;
  private final Mutater mutater;
  private final List<MutationDetails> details = new ArrayList<>();

  /**
   * @param patterns names of classes with {@code *} for any text, separated by commas
   * @throws BadInput if no class on the class path has such a name
   */
  Bugs(String patterns) {
    classes = classes(path, patterns);
    mutater =
        new GregorEngineFactory()
            .createEngine(
                EngineArguments.arguments()
                    .withMutators(List.of("STRONGER"))
                    .withExcludedMethods(LEFT_OUT))
            .createMutator(new ClassPathByteArraySource(path));
    for (String name : classes) {
      details.addAll(mutater.findMutations(ClassName.fromString(name)));
    }
    details.removeIf(bug -> LEFT_OUT.contains(bug.getMethod()));
    details.sort(
        Comparator.comparing(MutationDetails::getFilename)
            .thenComparing(MutationDetails::getLineNumber)
            .thenComparing(MutationDetails::getId));
  }

  /** The names of the classes, as the constructor finds them. */
  static SortedSet<String> classes(ClassPath path, String patterns) {
    Pattern names =
        Pattern.compile(
            Stream.of(patterns.split(","))
                .map(name -> Pattern.quote(name.strip()).replace("*", "\\E.*\\Q"))
                .collect(Collectors.joining("|")));
    SortedSet<String> classes =
        new TreeSet<>(path.findClasses(name -> names.matcher(name).matches()));
    classes.removeIf(name -> name.endsWith("package-info") || name.endsWith("module-info"));
    if (classes.isEmpty()) {
      throw new BadInput(
          "--classes: "
              + BadInput.quote(patterns)
              + ": expected names of classes on the class path, such as 'org.example.rover.*'");
    }
    return classes;
  }

  /** The number of bugs. */
  int count() {
    return details.size();
  }

  /** The classes, by name. */
  SortedSet<String> classes() {
    return Collections.unmodifiableSortedSet(classes);
  }

  /** What the class is without a bug. */
  byte[] bytes(String name) {
    try {
      return path.getClassData(name);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  String className(int bug) {
    return details.get(bug).getClassName().asJavaName();
  }

  String file(int bug) {
    return details.get(bug).getFilename();
  }

  int line(int bug) {
    return details.get(bug).getLineNumber();
  }

  /** {@code Rover.java:45: negated conditional, in next}. */
  String text(int bug) {
    MutationDetails one = details.get(bug);
    return "%s:%d: %s, in %s"
        .formatted(one.getFilename(), one.getLineNumber(), one.getDescription(), one.getMethod());
  }

  /** The class with the bug. */
  Map<String, byte[]> planted(int bug) {
    byte[] bytes = mutater.getMutation(details.get(bug).getId()).getBytes();
    return Map.of(className(bug), bytes);
  }
}
