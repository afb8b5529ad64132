package org.starl.cli.request;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Stream;
import java.util.zip.CRC32;
import org.starl.apps.Demo;
import org.starl.apps.Demos;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.cli.command.Shell;
import org.starl.input.BadInput;
import org.starl.input.NearMatches;
import org.starl.input.Quantities;
import org.starl.random.Rng;
import org.starl.sim.Redraws;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.SimulationPlan;
import org.starl.sim.fault.Envelope;
import org.starl.sim.fault.Fault;
import org.starl.sim.fault.FaultGrammar;
import org.starl.sim.fault.FaultPlan;
import org.starl.sim.view.ViewSettings;
import org.starl.trace.Vocabulary;

/**
 * A request to run an app, parsed from options, a scenario file, a deployment file or a trace
 * header. Immutable. It can render the command line that makes the same request.
 *
 * @param parameters of the app, the given ones only; their defaults apply to the others
 * @param settings the given ones only; the app's defaults apply to the others
 */
public record RunRequest(Demo demo, SortedMap<String, String> parameters, SimSettings settings) {

  /** The option of each setting that has one, in the order to show them. */
  static final Map<Setting<?>, String> OPTIONS = new LinkedHashMap<>();

  /** So many of the runs with chaos have seals, and an attacker without the key. */
  private static final double SEALED = 0.25;

  /** The words of a request without settings: the app and its seed. */
  private static final int PLAIN_WORDS = 3;

  static {
    OPTIONS.put(Setting.ROBOTS, "--robots");
    OPTIONS.put(Setting.DURATION, "--for");
    OPTIONS.put(Setting.MESSAGE_LOSS, "--loss");
    OPTIONS.put(Setting.MESSAGE_DELAY, "--delay");
    OPTIONS.put(Setting.POSITION_NOISE, "--gps-noise");
    OPTIONS.put(Setting.IDEAL_MOTION, "--ideal");
    OPTIONS.put(Setting.FAULTS, "--fault");
    OPTIONS.put(Setting.CHAOS, "--chaos");
  }

  /** The settings that a user can give: those of the simulator and of the window. */
  public static List<Setting<?>> known() {
    return Stream.concat(Setting.all().stream(), ViewSettings.all().stream()).toList();
  }

  /** The number of robots, if the user gave one. */
  public OptionalInt robots() {
    return settings.has(Setting.ROBOTS) ? OptionalInt.of(settings.robots()) : OptionalInt.empty();
  }

  /** The same request with other settings. */
  public RunRequest withSettings(SimSettings newSettings) {
    return new RunRequest(demo, parameters, newSettings);
  }

  /** The same request with these redraws, and no others. */
  public RunRequest with(Redraws redraws) {
    return withSettings(settings.with(Setting.REDRAWS, redraws));
  }

  /** The same request with these faults too. */
  public RunRequest withFaults(List<Fault> more) {
    FaultPlan all = settings.get(Setting.FAULTS).plus(new FaultPlan(more));
    return more.isEmpty() ? this : withSettings(settings.with(Setting.FAULTS, all));
  }

  /**
   * The plan for one seed, a new one at each call.
   *
   * @throws BadInput if a value is invalid
   */
  public Plan plan(long seed) {
    Request request = request(seed);
    SimSettings defaults = demo.defaultSettings(request).build();
    Plan plan = demo.plan(request, given(request).over(defaults));
    if (robots().orElse(1) == 0) { // most apps say how many they take
      throw new BadInput("robots: 0: expected at least 1");
    }
    plan.simulation().name(demo.name()).seed(seed).commands(() -> commands(seed));
    request.parameters().forEach(plan.simulation()::parameter);
    if (request.robots().isEmpty()) {
      plan.simulation().countedByScenario();
    }
    return plan;
  }

  /** A line if the user gave a number of robots that changes nothing; else empty. */
  public Optional<String> unusedRobots(long seed) {
    if (robots().isEmpty()) {
      return Optional.empty();
    }
    int given = robots().getAsInt();
    SimulationPlan plan = plan(seed).simulation().build().plan();
    int planned = plan.robots().size();
    // A director may let any number of robots join.
    if (planned == given || plan.director() != null) {
      return Optional.empty();
    }
    try {
      RunRequest more = withSettings(settings.with(Setting.ROBOTS, given + 1));
      if (more.plan(seed).simulation().build().plan().robots().size() != planned) {
        return Optional.empty();
      }
    } catch (BadInput refused) {
      return Optional.empty();
    }
    return Optional.of(
        "starl: --robots " + given + " changes nothing: " + demo.name() + " has " + planned);
  }

  /** The shapes of the values in a trace of such a run. */
  public Vocabulary vocabulary(long seed) {
    return demo.vocabulary(request(seed));
  }

  private Request request(long seed) {
    SortedMap<String, String> all = Parameter.values(demo.parameters(), parameters);
    Request request = new Request(seed, robots(), all, parameters.keySet());
    return settings.get(Setting.CHAOS) == Envelope.NONE ? request : demo.varied(request);
  }

  /** This request as {@link #plan} runs it: with what chaos varies. */
  public RunRequest varied(long seed) {
    Request request = request(seed);
    SortedMap<String, String> given = new TreeMap<>(request.parameters());
    given.keySet().retainAll(request.given());
    return new RunRequest(demo, given, given(request));
  }

  /** The settings with what chaos drew: the number of robots; in a quarter of the seeds, seals. */
  private SimSettings given(Request request) {
    SimSettings.Builder more = settings.toBuilder();
    if (settings.get(Setting.CHAOS) != Envelope.NONE
        && !settings.has(Setting.SEALED)
        && new Rng(request.seed()).fork("chaos/sealed").nextBoolean(SEALED)) {
      more.sealed(true);
    }
    request.robots().ifPresent(more::robots);
    return more.build();
  }

  /** The command line that runs this request with one seed. */
  public String replay(long seed) {
    List<String> words = new ArrayList<>(List.of("run"));
    words.addAll(words(seed));
    return Shell.starl(words);
  }

  /**
   * The usual file for a picture of the run, {@code out/mutex-7.png}. With other settings than the
   * default it has a number that depends on them, so that it does not replace that of another run.
   */
  public String file(long seed, String suffix) {
    List<String> words = words(seed);
    CRC32 number = new CRC32();
    number.update(String.join("\n", words).getBytes(StandardCharsets.UTF_8));
    String settings = words.size() == PLAIN_WORDS ? "" : "-%08x".formatted(number.getValue());
    return "out/" + demo.name() + "-" + seed + settings + "." + suffix;
  }

  /** The command lines for the description of a failure. */
  public List<String> commands(long seed) {
    String replay = "replay: " + replay(seed);
    if (seed < 0 || seed > Integer.MAX_VALUE) {
      return List.of(replay); // campaigns have no such seeds
    }
    return List.of(replay, "shrink: " + shrink(seed));
  }

  /** The command line that makes the run of one seed smaller. */
  public String shrink(long seed) {
    List<String> shrink = campaign(new Seeds.Range(seed, seed));
    shrink.add("--shrink");
    return Shell.starl(shrink);
  }

  /** The words of the campaign with these seeds. */
  public List<String> campaign(Seeds.Range seeds) {
    List<String> words = new ArrayList<>(List.of("campaign"));
    words.addAll(words(seeds.first()));
    int seed = words.indexOf("--seed");
    words.set(seed, "--seeds");
    words.set(seed + 1, seeds.size() == 1 ? Long.toString(seeds.first()) : seeds.toString());
    return words;
  }

  /** The words of that command line after {@code run}. */
  public List<String> words(long seed) {
    List<String> words = new ArrayList<>(List.of(demo.name(), "--seed", Long.toString(seed)));
    Map<Setting<?>, String> given = settings.given();
    for (Setting<?> setting : OPTIONS.keySet()) {
      String value = given.get(setting);
      if (value != null) {
        words.addAll(optionWords(setting, value));
      }
    }
    for (Parameter parameter : demo.parameters()) {
      String value = parameters.get(parameter.key());
      if (value != null) {
        words.addAll(List.of("--set", parameter.key() + "=" + value));
      }
    }
    given.keySet().removeAll(OPTIONS.keySet());
    given.forEach((setting, value) -> words.addAll(List.of("--set", setting.key() + "=" + value)));
    return words;
  }

  private List<String> optionWords(Setting<?> setting, String value) {
    String option = Objects.requireNonNull(OPTIONS.get(setting));
    if (setting == Setting.FAULTS) {
      return settings.get(Setting.FAULTS).faults().stream()
          .flatMap(fault -> Stream.of(option, fault.toString()))
          .toList();
    }
    boolean isFlag = setting == Setting.IDEAL_MOTION || setting == Setting.CHAOS;
    if (!isFlag) {
      return List.of(option, value);
    }
    boolean isOn =
        setting == Setting.CHAOS
            ? settings.get(Setting.CHAOS) == demo.envelope()
            : settings.get(Setting.IDEAL_MOTION);
    return isOn ? List.of(option) : List.of("--set", setting.key() + "=" + value);
  }

  /** Collects parameters and settings; later values replace earlier ones. */
  public static final class Builder {

    private final Demo demo;
    private final Set<String> declared;
    private final SortedMap<String, String> parameters = new TreeMap<>();
    private final SimSettings.Builder settings = SimSettings.builder();

    public Builder(Demo demo) {
      this.demo = demo;
      declared = demo.defaults().keySet();
    }

    /**
     * A request for the app with this name.
     *
     * @param where the place of the name, for errors: {@code my.yaml:1: }, or empty
     * @param hint for errors, after the similar names
     * @throws BadInput if no app has that name
     */
    public static Builder of(Demos demos, String name, String where, String hint) {
      return new Builder(
          demos
              .byName(name)
              .orElseThrow(() ->
                  new BadInput(
                      "%sno app is called %s%s%s"
                          .formatted(
                              where,
                              BadInput.quote(name),
                              NearMatches.hint(name, demos.names()),
                              hint))));
    }

    /**
     * Sets a setting or a parameter.
     *
     * @param where the place of the value, for errors: {@code --set: }, {@code my.yaml:3: }
     * @throws BadInput naming {@code where}, the key, the value and the expected form
     */
    public Builder set(String where, String key, String value) {
      if (declared.contains(key)) {
        parameters.put(key, value);
        return this;
      }
      try {
        settings.read(setting(key), key.equals(Setting.CHAOS.key()) ? envelope(value) : value);
      } catch (BadInput error) {
        throw new BadInput(where + error.getMessage());
      }
      return this;
    }

    /** Adds a fault. */
    public Builder fault(String text) {
      try {
        FaultPlan one = new FaultPlan(List.of(FaultGrammar.parse(text)));
        settings.set(Setting.FAULTS, settings.build().get(Setting.FAULTS).plus(one));
      } catch (BadInput error) {
        throw Quantities.in("--fault", error);
      }
      return this;
    }

    public RunRequest build() {
      return new RunRequest(demo, parameters, settings.build());
    }

    /** {@code chaos: true} means the envelope of the app. */
    private String envelope(String value) {
      return switch (value.strip()) {
        case "true", "yes", "on" -> demo.envelope().toString();
        case "false", "no", "off" -> Envelope.NONE.toString();
        default -> value;
      };
    }

    private Setting<?> setting(String key) {
      for (Setting<?> setting : known()) {
        if (setting.key().equals(key)) {
          return setting;
        }
      }
      List<String> keys = new ArrayList<>(declared);
      known().forEach(setting -> keys.add(setting.key()));
      throw new BadInput(
          "no setting or parameter is called " + BadInput.quote(key) + NearMatches.hint(key, keys));
    }
  }
}
