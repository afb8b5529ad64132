package org.starl.lang.check;

import java.io.IOException;
import java.io.InputStream;
import java.io.StringWriter;
import java.lang.reflect.Constructor;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.jspecify.annotations.Nullable;
import org.starl.apps.intersection.robot.IntersectionFactory;
import org.starl.lang.java.JavaSources;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.tree.Automaton;
import org.starl.shape.JsonFormatException;
import org.starl.shape.JsonReader;
import org.starl.shape.RecordShape;
import org.starl.shape.Shape;
import org.starl.sim.SimObserver;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;
import org.starl.trace.Var;
import org.starl.trace.Vocabulary;
import org.starl.workload.Runs;

/**
 * A conformance monitor over the Java of another automaton than its own: the monitor's class, as it
 * is, loaded again with all primitives beside that Java. Facts, variables and messages have values of
 * these classes, so each event is read again from its JSON, as of a recorded trace.
 */
final class MutantReplay {

  private static final String PRIMITIVES = "org.starl.primitives.";
  private static final String INTERSECTION = "org.starl.apps.intersection.";

  /**
   * The demo and the conformance monitor of an automaton with Java.
   *
   * @param parameters in turn, seed by seed
   * @param settings in place of chaos, if there are any
   * @param argument of the monitor's constructor; null for none, or the default one of its type
   * @param vocabulary the constant of the class {@code words}
   */
  private record Twin(
      String demo,
      List<Map<String, String>> parameters,
      Map<String, String> settings,
      String monitor,
      @Nullable String argument,
      String words,
      String vocabulary) {

    static Twin of(String workload, List<Map<String, String>> parameters, String monitor) {
      return new Twin(
          workload,
          parameters,
          Map.of(),
          PRIMITIVES + monitor,
          null,
          PRIMITIVES + "monitor.PrimitiveVocabulary",
          "ALL");
    }

    static Twin of(String workload, String monitor) {
      return of(workload, List.of(Map.of()), monitor);
    }
  }

  private static final Map<String, String> SEQUENCES = Map.of("order", "sequence");

  private static final Map<String, Twin> TWINS =
      Map.ofEntries(
          Map.entry("Mutex_decls", Twin.of("mutex", "mutex.MutexConformance")),
          Map.entry(
              "MutexProtocol_decls",
              Twin.of("mutex", List.of(Map.of(), SEQUENCES), "mutex.ProtocolConformance")),
          Map.entry(
              "Pipeline_decls", Twin.of("mutex", List.of(SEQUENCES), "mutex.PipelineConformance")),
          Map.entry("Modes_decls", Twin.of("mutex", "mutex.ModesConformance")),
          Map.entry(
              "Registration_decls",
              Twin.of("registration", "registration.RegistrationConformance")),
          Map.entry("Synod_decls", Twin.of("agreement", "agreement.SynodConformance")),
          Map.entry("SetAgreement_decls", Twin.of("agreement", "agreement.AgreementConformance")),
          Map.entry("Election_decls", Twin.of("election", "election.ElectionConformance")),
          Map.entry("Barrier_decls", Twin.of("barrier", "barrier.BarrierConformance")),
          Map.entry("Ledger_decls", Twin.of("ledger", "ledger.LedgerConformance")),
          Map.entry("Geocast_decls", Twin.of("geocast", "geocast.GeocastConformance")),
          Map.entry("MotionControl_decls", Twin.of("motion", "motion.MotionConformance")),
          // Cars crash among the zones, and go on from there.
          Map.entry(
              "Traffic_decls",
              new Twin(
                  "intersection",
                  List.of(Map.of("car", "paper")),
                  Map.of(
                      "messageLoss",
                      "0.2",
                      "faults",
                      "crash(bot0,at=9s,restart=5s); crash(bot2,at=14s,restart=5s)"),
                  INTERSECTION + "spec.TrafficConformance",
                  IntersectionFactory.XID,
                  INTERSECTION + "logic.CrossingFact",
                  "FIGURE_4")));

  /** One for all: what it has read of the JDK and of the libraries stays read. */
  private static final JavaCompiler COMPILER = ToolProvider.getSystemJavaCompiler();

  private static final StandardJavaFileManager FILES =
      COMPILER.getStandardFileManager(null, null, null);

  private final String name;
  private final Constructor<?> monitor;
  private final Object[] settings;
  private final Vocabulary vocabulary;
  private Monitors monitors;
  private boolean isSeen;

  private MutantReplay(
      String name, Constructor<?> monitor, Object[] settings, Vocabulary vocabulary) {
    this.name = name;
    this.monitor = monitor;
    this.settings = settings;
    this.vocabulary = vocabulary;
    monitors = fresh();
  }

  private Monitors fresh() {
    try {
      return new Monitors(List.of((Monitor) monitor.newInstance(settings)));
    } catch (ReflectiveOperationException e) {
      throw new AssertionError(e);
    }
  }

  static boolean hasMonitor(Automaton automaton) {
    return TWINS.containsKey(automaton.name());
  }

  /**
   * A monitor over {@code automaton}; none if the automaton has no Java form.
   *
   * @param folder for its classes, as long as it is used
   */
  static Optional<MutantReplay> of(String name, Automaton automaton, Path folder)
      throws IOException {
    Map<String, String> files;
    try {
      files = JavaSources.of(automaton, "x.starl");
    } catch (SourceErrors e) {
      return Optional.empty();
    }
    Loader loader = new Loader(compiled(files, folder));
    try {
      Twin twin = twin(automaton);
      Class<?> monitor = loader.loadClass(twin.monitor);
      Constructor<?> constructor = monitor.getConstructors()[0];
      for (Constructor<?> each : monitor.getConstructors()) {
        constructor = each.getParameterCount() == 0 ? each : constructor;
      }
      Object[] settings = new Object[constructor.getParameterCount()];
      if (settings.length > 0) {
        Class<?> type = constructor.getParameterTypes()[0];
        settings[0] = twin.argument == null ? type.getField("DEFAULT").get(null) : twin.argument;
      }
      Object vocabulary = loader.loadClass(twin.words).getField(twin.vocabulary).get(null);
      return Optional.of(new MutantReplay(name, constructor, settings, (Vocabulary) vocabulary));
    } catch (ReflectiveOperationException e) {
      throw new AssertionError(e);
    }
  }

  private static Twin twin(Automaton automaton) {
    return Objects.requireNonNull(TWINS.get(automaton.name()));
  }

  String name() {
    return name;
  }

  /** Whether the monitor has reported a violation in some run, or its automaton has thrown. */
  boolean isSeen() {
    return isSeen;
  }

  private void act(Runnable observing) {
    if (!isSeen) {
      try {
        observing.run();
        isSeen = !monitors.report().holds();
      } catch (RuntimeException e) {
        isSeen = true; // an operation has no value: the run ends with this error
      }
    }
  }

  /** {@code event} with a fact or a value of this monitor's classes. */
  private TraceEvent seenHere(TraceEvent event) {
    return switch (event) {
      case Action e -> {
        RecordShape<?> here = vocabulary.fact(e.source(), e.shape().name());
        yield here == null
            ? e
            : new Action(e.timeNs(), e.robot(), e.source(), here, copy(e.shape(), e.fact(), here));
      }
      case Variable e -> {
        Var<?> here = vocabulary.variable(e.source(), e.name());
        Object value = copy(e.variable().shape(), e.value(), here.shape());
        yield new Variable(e.timeNs(), e.robot(), e.source(), here, value);
      }
      case Sent e -> {
        Shape<?> here = vocabulary.message(e.channel());
        Object message = copy(e.shape(), e.message(), here);
        yield new Sent(
            e.timeNs(), e.robot(), e.to(), e.channel(), e.seq(), e.bytes(), here, message);
      }
      case Delivered e -> {
        Shape<?> here = vocabulary.message(e.channel());
        Object message = copy(e.shape(), e.message(), here);
        yield new Delivered(e.timeNs(), e.robot(), e.from(), e.channel(), e.seq(), here, message);
      }
      default -> event;
    };
  }

  @SuppressWarnings("unchecked") // an event's value has the event's shape
  private static <V> Object copy(Shape<V> from, Object value, Shape<?> to) {
    try {
      return to.readJson(new JsonReader("event", 1, from.json((V) value)));
    } catch (JsonFormatException e) {
      throw new AssertionError(e);
    }
  }

  /** Simulates the automaton's demo with faults, each of {@code replays} with a look at all of it. */
  static void run(Automaton automaton, long seed, List<MutantReplay> replays) {
    Twin twin = twin(automaton);
    int turn = (int) (seed % twin.parameters.size());
    Map<String, String> parameters = new HashMap<>(twin.parameters.get(turn));
    replays.forEach(each -> each.monitors = each.fresh());
    parameters.putAll(
        twin.settings.isEmpty()
            ? Map.of("chaos", Runs.demo(twin.demo).envelope().toString())
            : twin.settings);
    var plan = Runs.plan(twin.demo, seed, parameters);
    long[] end = new long[1];
    plan.simulation()
        .observer(
            new SimObserver() {
              @Override
              public void observed(TraceEvent event) {
                end[0] = event.timeNs();
                replays.forEach(
                    each -> each.act(() -> each.monitors.observe(each.seenHere(event))));
              }
            });
    plan.simulation().build().run();
    replays.forEach(each -> each.act(() -> each.monitors.finish(end[0])));
  }

  private static Path compiled(Map<String, String> files, Path parent) throws IOException {
    Path folder = Files.createTempDirectory(parent, "mutant");
    List<String> paths = new ArrayList<>();
    for (Map.Entry<String, String> file : files.entrySet()) {
      Path path = folder.resolve(file.getKey());
      Files.createDirectories(path.getParent());
      Files.writeString(path, file.getValue());
      paths.add(path.toString());
    }
    StringWriter out = new StringWriter();
    List<String> options =
        List.of(
            "-d", folder.toString(), "-cp", System.getProperty("java.class.path"), "-proc:none");
    if (!COMPILER
        .getTask(out, FILES, null, options, null, FILES.getJavaFileObjectsFromStrings(paths))
        .call()) {
      throw new AssertionError(out.toString());
    }
    return folder;
  }

  /** Loads the primitives and the intersection anew, with the compiled classes in place of their own. */
  private static final class Loader extends ClassLoader {

    private final Path folder;

    Loader(Path folder) {
      super(MutantReplay.class.getClassLoader());
      this.folder = folder;
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
      String file = name.replace('.', '/') + ".class";
      boolean isNew = name.startsWith(PRIMITIVES) || name.startsWith(INTERSECTION);
      if (!isNew || findLoadedClass(name) != null) {
        return super.loadClass(name, resolve);
      }
      try (InputStream in =
          Files.exists(folder.resolve(file))
              ? Files.newInputStream(folder.resolve(file))
              : getResourceAsStream(file)) {
        if (in == null) {
          throw new ClassNotFoundException(name);
        }
        byte[] bytes = in.readAllBytes();
        return defineClass(name, bytes, 0, bytes.length);
      } catch (IOException e) {
        throw new ClassNotFoundException(name, e);
      }
    }
  }
}
