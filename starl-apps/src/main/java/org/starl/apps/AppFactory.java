package org.starl.apps;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.input.BadInput;
import org.starl.input.FailureText;
import org.starl.primitives.monitor.PrimitiveVocabulary;
import org.starl.trace.Vocabulary;

/**
 * Makes an app's program for robots, without the simulator: a phone has nothing else. Two methods are
 * enough: name and program. The app's {@link Demo} takes name, parameters and program from here, so a
 * phone, a board and the simulator run the same.
 *
 * <p>An app of your own gets onto a phone by a file on the class path, {@code
 * META-INF/services/org.starl.apps.AppFactory}, that contains the name of the implementing class, which
 * needs a public constructor without parameters. That class and all that it uses may use core, input
 * and primitives, and of Java as much as Android 8 has.
 */
public interface AppFactory {

  /** The name in a deployment file's {@code app:}. */
  String name();

  /** The parameters that a deployment file may set. */
  default List<Parameter> parameters() {
    return List.of();
  }

  /** Each parameter's default value by its key; the caller may change the map. */
  default SortedMap<String, String> defaults() {
    return Parameter.values(parameters(), Map.of());
  }

  /**
   * The shapes of this app's messages, facts and variables, for readers of traces; without them a
   * trace that is read has the app's own values as JSON.
   */
  default Vocabulary vocabulary(Request request) {
    return PrimitiveVocabulary.ALL;
  }

  /**
   * The program of each robot; equal requests give equal programs.
   *
   * @throws BadInput if a value cannot be used on robots; the message names it
   */
  RobotProgram program(Request request);

  /**
   * The factories that files {@code META-INF/services/org.starl.apps.AppFactory} on the class path of
   * this class name, by the apps' names.
   *
   * @throws BadInput if a factory cannot be created, or two apps have one name
   */
  static SortedMap<String, AppFactory> installed() {
    SortedMap<String, AppFactory> installed = new TreeMap<>();
    try {
      // On a phone, threads may have another class loader than the app's.
      for (AppFactory factory :
          ServiceLoader.load(AppFactory.class, AppFactory.class.getClassLoader())) {
        AppFactory other = installed.put(factory.name(), factory);
        if (other != null) {
          throw new BadInput(
              String.format(
                  "%s: its name %s is taken by %s; expected another",
                  factory.getClass().getName(),
                  BadInput.quote(factory.name()),
                  other.getClass().getName()));
        }
      }
    } catch (ServiceConfigurationError error) {
      throw FailureText.service(AppFactory.class, error);
    }
    return Collections.unmodifiableSortedMap(installed);
  }
}
