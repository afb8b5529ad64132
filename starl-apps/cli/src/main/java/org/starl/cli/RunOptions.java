package org.starl.cli;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Demo;
import org.starl.apps.Demos;
import org.starl.input.BadInput;
import org.starl.input.NearMatches;
import org.starl.input.Quantities;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.fault.Envelope;
import org.starl.sim.fault.Fault;
import org.starl.sim.fault.FaultGrammar;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** The options of every command that runs an app. */
final class RunOptions {

  @Parameters(
      index = "0",
      paramLabel = "APP|PRIMITIVE|FILE.yaml",
      description = "An app or a primitive ('starl list' names them), or a scenario file.")
  private String what = "";

  @Option(names = "--robots", paramLabel = "N", description = "How many robots.")
  private @Nullable String robots;

  @Option(
      names = "--for",
      paramLabel = "TIME",
      description = "Simulated time after which the run ends (60s); 1200s unless given.")
  private @Nullable String duration;

  @Option(
      names = "--loss",
      paramLabel = "P",
      description = "Probability 0..1 that a datagram is lost, for each recipient.")
  private @Nullable String loss;

  @Option(
      names = "--delay",
      paramLabel = "TIME",
      description =
          "How long a datagram takes: 100ms, 'uniform(10ms,20ms)', 'normal(100ms,20ms)',"
              + " 'exponential(50ms)'.")
  private @Nullable String delay;

  @Option(
      names = "--gps-noise",
      paramLabel = "LENGTH",
      description = "A position fix lies at most this far from the truth (20mm).")
  private @Nullable String gpsNoise;

  @Option(
      names = "--ideal",
      description = "Ideal motion: turns at once, drives straight, passes through everything.")
  private boolean ideal;

  @Option(
      names = "--fault",
      paramLabel = "FAULT",
      description =
          "Something that goes wrong: 'crash(bot2,at=12s,restart=5s)', 'loss(0.9,from=bot1)';"
              + " 'starl list' names them. May be repeated.")
  private List<String> faults = new ArrayList<>();

  @Option(
      names = "--chaos",
      description =
          "Faults drawn by seed, of those that the app must bear; they come and go in the first"
              + " part of the run ('--set chaosFor=60s'), and then all is well.")
  private boolean chaos;

  @Option(
      names = "--set",
      paramLabel = "KEY=VALUE",
      description = "Any other setting or parameter; 'starl list' names them.")
  private Map<String, String> sets = new LinkedHashMap<>();

  /** What is named, as the user wrote it. */
  String what() {
    return what;
  }

  /**
   * Nothing may be said of a run that is over.
   *
   * @throws BadInput if something is
   */
  void requireNoneFor(String trace) {
    List<String> said = words(0);
    List<String> nothing = List.of(what, "--seed", "0");
    if (said.size() > nothing.size()) {
      throw new BadInput(
          said.get(nothing.size())
              + ": "
              + trace
              + " is a run that is over; expected nothing that would change it");
    }
  }

  /** What to run, which is one of {@code demos}. */
  Chosen chosen(Demos demos) {
    boolean isFile = ScenarioFile.isOne(what);
    return chosen(demos, isFile ? ScenarioFile.read(what) : ScenarioFile.ofApp(what));
  }

  /** The command line that says the same again. */
  String replay(String command, long seed) {
    List<String> words = new ArrayList<>(List.of(command));
    words.addAll(words(seed));
    return Shell.starl(words);
  }

  /** The words after the command that say the same again. */
  List<String> words(long seed) {
    List<String> words = new ArrayList<>(List.of(what, "--seed", Long.toString(seed)));
    add(words, "--robots", robots);
    add(words, "--for", duration);
    add(words, "--loss", loss);
    add(words, "--delay", delay);
    add(words, "--gps-noise", gpsNoise);
    if (ideal) {
      words.add("--ideal");
    }
    faults.forEach(fault -> add(words, "--fault", fault));
    if (chaos) {
      words.add("--chaos");
    }
    sets.forEach((key, value) -> add(words, "--set", key + "=" + value));
    return words;
  }

  private static void add(List<String> words, String option, @Nullable String value) {
    if (value != null) {
      words.add(option);
      words.add(value);
    }
  }

  private static Demo demo(Demos demos, ScenarioFile file) {
    return demos
        .byName(file.app())
        .orElseThrow(() ->
            new BadInput(
                file.where("app")
                    + "no app is called "
                    + BadInput.quote(file.app())
                    + NearMatches.hint(file.app(), demos.names())
                    + " (a scenario file's name ends in .yaml)"));
  }

  /** The same of what {@code file} says. */
  Chosen chosen(Demos demos, ScenarioFile file) {
    Demo demo = demo(demos, file);
    SortedMap<String, String> parameters = demo.defaults();
    Map<String, String> settings = new LinkedHashMap<>();
    file.values()
        .forEach((key, value) ->
            set(file.where(key), key, meant(demo, key, value), parameters, settings));
    for (String fault : faults) {
      addFault(fault, settings);
    }
    for (Flag flag : flags()) {
      String value = meant(demo, flag.key(), flag.value());
      set(flag.option() + ": ", flag.key(), value, parameters, settings);
    }
    return Chosen.of(demo, parameters, settings);
  }

  /** {@code chaos: true} is what the app must bear. */
  private static String meant(Demo demo, String key, String value) {
    if (!key.equals(Setting.CHAOS.key())) {
      return value;
    }
    return switch (value.strip()) {
      case "true", "yes", "on" -> demo.envelope().toString();
      case "false", "no", "off" -> Envelope.NONE.toString();
      default -> value;
    };
  }

  /** Besides those of the scenario file. */
  private static void addFault(String text, Map<String, String> settings) {
    Fault fault;
    try {
      fault = FaultGrammar.parse(text);
    } catch (BadInput error) {
      throw Quantities.in("--fault", error);
    }
    settings.merge(Setting.FAULTS.key(), fault.toString(), (a, b) -> a + "; " + b);
  }

  private record Flag(String option, String key, String value) {}

  /** What the flags say; {@code --set} has the last word. */
  private List<Flag> flags() {
    List<Flag> flags = new ArrayList<>();
    add(flags, "--robots", Setting.ROBOTS, robots);
    add(flags, "--for", Setting.DURATION, duration);
    add(flags, "--loss", Setting.MESSAGE_LOSS, loss);
    add(flags, "--delay", Setting.MESSAGE_DELAY, delay);
    add(flags, "--gps-noise", Setting.POSITION_NOISE, gpsNoise);
    add(flags, "--ideal", Setting.IDEAL_MOTION, ideal ? "true" : null);
    add(flags, "--chaos", Setting.CHAOS, chaos ? "true" : null);
    sets.forEach((key, value) -> flags.add(new Flag("--set", key, value)));
    return flags;
  }

  private static void add(
      List<Flag> flags, String option, Setting<?> setting, @Nullable String value) {
    if (value != null) {
      flags.add(new Flag(option, setting.key(), value));
    }
  }

  private static void set(
      String where,
      String key,
      String value,
      SortedMap<String, String> parameters,
      Map<String, String> settings) {
    if (parameters.containsKey(key)) {
      parameters.put(key, value);
      return;
    }
    try {
      if (Setting.all().stream().noneMatch(setting -> setting.key().equals(key))) {
        throw unknown(key, parameters.keySet());
      }
      // Only to find out whether it can be read.
      SimSettings.builder().set(key, value);
    } catch (BadInput error) {
      throw new BadInput(where + error.getMessage());
    }
    settings.put(
        key,
        key.equals(Setting.ROBOTS.key())
            ? Long.toString(Quantities.whole(value, 0, Integer.MAX_VALUE))
            : value);
  }

  private static BadInput unknown(String key, Collection<String> parameters) {
    List<String> keys = new ArrayList<>(parameters);
    Setting.all().forEach(setting -> keys.add(setting.key()));
    return new BadInput(
        "no setting or parameter is called " + BadInput.quote(key) + NearMatches.hint(key, keys));
  }
}
