package org.starl.apps;

import java.nio.file.Path;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.sim.SimSettings;
import org.starl.sim.fault.Envelope;

/**
 * An app with its scenarios, as the command line knows it. Three methods are enough: a name, a
 * summary, and the plan of a run.
 *
 * <p>An app of your own becomes part of the command line by a file on the class path, {@code
 * META-INF/services/org.starl.apps.Demo}, that holds the name of the class that implements this; it
 * needs a public constructor without parameters.
 */
public interface Demo {

  /** What it shows. */
  enum Kind {
    APP,
    /** A workload of one primitive. */
    PRIMITIVE
  }

  default Kind kind() {
    return Kind.APP;
  }

  /** As in {@code starl run NAME}. */
  String name();

  /** One line. */
  String summary();

  /** The app's scenarios, for {@code --set scenario=NAME}; empty if it has but one. */
  default List<Scenario> scenarios() {
    return List.of();
  }

  /** What {@code --set} may change besides the simulator's settings. */
  default List<Parameter> parameters() {
    return List.of();
  }

  /** Each parameter's default value, by its key; a map of the caller's own. */
  default SortedMap<String, String> defaults() {
    SortedMap<String, String> defaults = new TreeMap<>();
    parameters().forEach(parameter -> defaults.put(parameter.key(), parameter.defaultValue()));
    return defaults;
  }

  /**
   * What it can be run on of a folder with the input files of the original StarL and with grid maps:
   * {@code starl bench apps} makes a table of it.
   */
  default List<Input> inputs(Path data) {
    return List.of();
  }

  /** What chaos draws from: the faults under which the app's specifications hold. */
  default Envelope envelope() {
    return Envelope.LOGICAL;
  }

  /** The simulator's settings where the user says nothing else. */
  default SimSettings.Builder defaultSettings(Request request) {
    return SimSettings.builder();
  }

  /**
   * The simulation of {@code request}: equal requests give equal simulations.
   *
   * @throws org.starl.input.BadInput if a value cannot be used; the message names it
   */
  Plan plan(Request request, SimSettings settings);
}
