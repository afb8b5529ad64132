package org.starl.apps;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import org.starl.primitives.monitor.PrimitiveVocabulary;
import org.starl.sim.SimSettings;
import org.starl.sim.fault.Envelope;
import org.starl.trace.Vocabulary;

/**
 * An app with its scenarios, for the command line. Three methods are enough: name, summary and
 * plan.
 *
 * <p>An app of your own becomes part of the command line by a file on the class path, {@code
 * META-INF/services/org.starl.apps.Demo}, that contains the name of the implementing class, which
 * needs a public constructor without parameters.
 */
public interface Demo {

  /** The kind of a demo. */
  enum Kind {
    APP,
    /** A workload of one primitive. */
    PRIMITIVE
  }

  default Kind kind() {
    return Kind.APP;
  }

  /** The name in {@code starl run NAME}. */
  String name();

  /** A description in one line. */
  String summary();

  /** The app's scenarios, for {@code --set scenario=NAME}; empty if there is only one. */
  default List<Scenario> scenarios() {
    return List.of();
  }

  /** Parameters that {@code --set} may change besides the simulator's settings. */
  default List<Parameter> parameters() {
    return List.of();
  }

  /** Each parameter's default value by its key; the caller may change the map. */
  default SortedMap<String, String> defaults() {
    return Parameter.values(parameters(), Map.of());
  }

  /**
   * The input files of this app in a folder with the original StarL's files and grid maps, for the
   * table of {@code starl bench apps}.
   */
  default List<Input> inputs(Path data) {
    return List.of();
  }

  /** The faults under which the app's specifications hold; chaos draws from them. */
  default Envelope envelope() {
    return Envelope.LOGICAL;
  }

  /**
   * A request with chaos, varied by its seed: groups of other sizes, other parameters. What the user
   * gave stays.
   */
  default Request varied(Request request) {
    return request;
  }

  /**
   * The shapes of this app's messages, facts and variables, for readers of traces; without them a
   * trace that is read has the app's own values as JSON.
   */
  default Vocabulary vocabulary(Request request) {
    return PrimitiveVocabulary.ALL;
  }

  /** The simulator's default settings for this app. */
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
