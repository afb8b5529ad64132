package org.starl.lang.java;

import java.io.IOException;
import java.io.StringWriter;
import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.LongStream;
import javax.tools.ToolProvider;
import org.starl.lang.read.Source;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.spec.automaton.Action;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.Enabled;
import org.starl.spec.automaton.Undefined;

/** The Java of a source, compiled and loaded: {@code automaton x.XAutomaton}. */
final class Compiled {

  private final ClassLoader loader;
  private final Automaton<Object, Action> automaton;
  private Object state;

  /**
   * @param text of an automaton whose class is {@code x.XAutomaton}
   * @param parameters the values of its parameters, numbers
   */
  Compiled(String text, long... parameters) throws SourceErrors {
    this(files(text), LongStream.of(parameters).boxed().toArray());
  }

  /**
   * @param sources with a class {@code x.XAutomaton}
   * @param parameters the values of its parameters
   */
  @SuppressWarnings("unchecked") // the class is not known before the test runs
  Compiled(Map<String, String> sources, Object[] parameters) {
    try {
      // Classes are loaded from it until the tests end.
      Path folder = Files.createTempDirectory(Files.createDirectories(Path.of("target")), "java");
      List<String> files = new ArrayList<>();
      for (Map.Entry<String, String> file : sources.entrySet()) {
        Path path = folder.resolve(file.getKey());
        Files.createDirectories(path.getParent());
        Files.writeString(path, file.getValue());
        files.add(path.toString());
      }
      compile(folder, files);
      loader = new URLClassLoader(new URL[] {folder.toUri().toURL()});
      automaton =
          (Automaton<Object, Action>)
              loader.loadClass("x.XAutomaton").getConstructors()[0].newInstance(parameters);
    } catch (InvocationTargetException e) {
      if (e.getCause() instanceof Undefined undefined) {
        throw undefined;
      }
      throw new AssertionError(e);
    } catch (IOException | ReflectiveOperationException e) {
      throw new AssertionError(e);
    }
    state = automaton.start();
  }

  static Map<String, String> files(String text) throws SourceErrors {
    Source source = new SourceReader().look("x.starl", text, null);
    if (!source.errors().isEmpty()) {
      throw new SourceErrors(source.errors());
    }
    return JavaSources.of(source, "x.starl");
  }

  private static void compile(Path folder, List<String> files) throws IOException {
    var compiler = ToolProvider.getSystemJavaCompiler();
    StringWriter out = new StringWriter();
    try (var manager = compiler.getStandardFileManager(null, null, null)) {
      List<String> options =
          List.of(
              "-d",
              folder.toString(),
              "-cp",
              System.getProperty("java.class.path"),
              "-proc:none",
              "-Xlint:all",
              "-Werror");
      boolean isGood =
          compiler
              .getTask(
                  out, manager, null, options, null, manager.getJavaFileObjectsFromStrings(files))
              .call();
      if (!isGood) {
        throw new AssertionError(out + Files.readString(Path.of(files.getLast())));
      }
    }
  }

  /** Goes to the start state. */
  void begin() {
    state = automaton.start();
  }

  /** {@code action("take", "bot1")}. */
  Action action(String name, Object... arguments) {
    try {
      Constructor<?> constructor =
          loader.loadClass("x.XAction$" + name).getDeclaredConstructors()[0];
      constructor.setAccessible(true);
      return (Action) constructor.newInstance(arguments);
    } catch (ReflectiveOperationException e) {
      throw new AssertionError(e);
    }
  }

  Enabled enabled(String name, Object... arguments) {
    return automaton.enabled(action(name, arguments), state);
  }

  /** Takes an action; returns the state as text. */
  String step(String name, Object... arguments) {
    state = automaton.trans(action(name, arguments), state);
    return state.toString();
  }

  /** The state after an action, which is not taken. */
  Object after(String name, Object... arguments) {
    return automaton.trans(action(name, arguments), state);
  }

  /** Goes to a state. */
  void go(Object to) {
    state = to;
  }

  Object value() {
    return state;
  }

  /** The values of an enumeration. */
  Object[] enumerated(String type) throws ReflectiveOperationException {
    return loader.loadClass("x.XAutomaton$" + type).getEnumConstants();
  }

  ClassLoader loader() {
    return loader;
  }

  String state() {
    return state.toString();
  }
}
