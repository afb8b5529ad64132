package org.starl.workload;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.starl.apps.Demo;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.input.BadInput;
import org.starl.input.Form;
import org.starl.input.Quantities;
import org.starl.input.Quantity;
import org.starl.primitives.geocast.GeocastFact;
import org.starl.primitives.geocast.GeocastMessage;
import org.starl.primitives.ledger.LedgerSettings;
import org.starl.primitives.monitor.PrimitiveVocabulary;
import org.starl.primitives.mutex.MutexTimes;
import org.starl.shape.Shapes;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;
import org.starl.sim.record.Layer;
import org.starl.time.Time;
import org.starl.trace.Vocabulary;

/** The primitives that have a workload. */
public final class PrimitiveWorkloads {

  /** The shapes of what the workloads send and tell. */
  private static final Vocabulary VOCABULARY =
      PrimitiveVocabulary.ALL
          .messages(MailFact.SOURCE.name(), MessagesClient.Letter.SHAPE)
          .messages(GeocastFact.GEOCAST, GeocastMessage.shape(Shapes.INT))
          .messages(GeocastFact.BROADCAST, GeocastMessage.shape(Shapes.INT))
          .facts(MailFact.SOURCE.name(), MailFact.SHAPE)
          .facts(ClientFact.SOURCE.name(), ClientFact.SHAPE);

  /** By name. */
  public static final List<Demo> ALL =
      List.of(
          new Workload(
              "agreement",
              "robots agree on one value after another, each proposing its own",
              Envelope.LOGICAL,
              64,
              Duration.ofSeconds(4),
              parameters(10, "20s", Setup.PATIENCE),
              List.of(new Variant(Setup.PATIENCE, Setup.SHORT)),
              AgreementClient::setUp),
          new Workload(
              "barrier",
              "registered robots meet at a barrier again and again",
              Envelope.LOGICAL,
              32,
              Duration.ofMillis(BarrierClient.DEADLINE_MS),
              parameters(10, "20s"),
              List.of(),
              BarrierClient::setUp),
          new Workload(
              "election",
              "robots elect one leader after another, and follow all of them",
              Envelope.LOGICAL,
              64,
              Duration.ofMillis(ElectionClient.DEADLINE_MS),
              parameters(5, "20s", ElectionClient.STRATEGY),
              List.of(new Variant(ElectionClient.STRATEGY, "bully")),
              ElectionClient::setUp),
          new Workload(
              "geocast",
              "moving robots send to areas of all shapes, and to all robots",
              Envelope.PHYSICAL,
              64,
              Duration.ofMillis(GeocastClient.MAX_D_MS),
              parameters(12, "20s"),
              List.of(),
              GeocastClient::setUp,
              GeocastClient::settings),
          new Workload(
              "ledger",
              "robots add tasks to a ledger, claim them, do them and finish them",
              Envelope.LOGICAL,
              32,
              Duration.ofMillis(LedgerSettings.DEFAULT.leaseMs()),
              parameters(5, "20s", Setup.PATIENCE, LedgerClient.ALLOCATION),
              List.of(
                  new Variant(Setup.PATIENCE, Setup.SHORT),
                  new Variant(LedgerClient.ALLOCATION, LedgerClient.AUCTION)),
              LedgerClient::setUp),
          new Workload(
              "messages",
              "robots send letters to one and to all, reliably and not, on channels that close",
              Envelope.LOGICAL,
              32,
              Duration.ofSeconds(10),
              parameters(10, "20s"),
              List.of(),
              MessagesClient::setUp),
          new Workload(
              "motion",
              "robots drive to random places, outside regions that may be in the way",
              Envelope.UNLOCATED,
              64,
              Duration.ofSeconds(2),
              parameters(8, "20s"),
              List.of(),
              MotionClient::setUp,
              MotionClient::settings),
          new Workload(
              "mutex",
              "robots enter sets of sections, each again and again, over a registration",
              Envelope.LOGICAL,
              32,
              Duration.ofMillis(MutexTimes.DEFAULT.suspectMs()),
              parameters(
                  10,
                  "20s",
                  MutexClient.SECTIONS,
                  MutexClient.MEMBERS,
                  MutexClient.SUSPECT,
                  MutexClient.ORDER,
                  MutexClient.MODES,
                  MutexClient.CAPACITY),
              List.of(
                  new Variant(MutexClient.SECTIONS, "2"),
                  new Variant(MutexClient.MEMBERS, MutexClient.CHANGING),
                  new Variant(MutexClient.SUSPECT, MutexClient.SOON),
                  new Variant(MutexClient.ORDER, MutexClient.SEQUENCE),
                  new Variant(MutexClient.MODES, "2"),
                  new Variant(MutexClient.CAPACITY, "2")),
              MutexClient::setUp),
          new Workload(
              "paths",
              "robots drive all over a floor with walls, in tubes that never meet",
              Envelope.PHYSICAL,
              16,
              Duration.ofMillis(PathsClient.TUBES.deadlineMs()),
              parameters(6, "60s", PathsClient.PLANNER),
              List.of(),
              PathsClient::setUp,
              PathsClient::settings),
          new Workload(
              "registration",
              "robots register, stay a while, and unregister, again and again",
              Envelope.LOGICAL,
              32,
              Duration.ofSeconds(10),
              parameters(10, "20s", Setup.PATIENCE, RegistrationClient.VOTERS),
              List.of(
                  new Variant(Setup.PATIENCE, Setup.SHORT),
                  new Variant(RegistrationClient.VOTERS, RegistrationClient.MOST)),
              RegistrationClient::setUp));

  private static final int DEFAULT_ROBOTS = 5;

  /** Chaos draws groups of so many robots: even ones and odd ones. */
  private static final int LEAST_DRAWN = 2;

  private static final int MOST_DRAWN = 12;

  /** In half of its runs chaos lasts longer by so many of the longest timeouts. */
  private static final int TIMEOUTS = 3;

  /** Chaos that lasts so long is long enough. */
  private static final long LONG_MS = 60_000;

  private PrimitiveWorkloads() {}

  /** The parameters that all workloads have, rounds and busy, and more. */
  private static List<Parameter> parameters(int rounds, String busy, Parameter... more) {
    List<Parameter> parameters = new ArrayList<>();
    parameters.add(
        new Parameter(
            "rounds",
            Integer.toString(rounds),
            "number of requests of each robot",
            Form.whole(1, Course.MAX_ROUNDS)));
    parameters.add(
        new Parameter(
            "busy",
            busy,
            "simulated time of rounds and chaos; the last three rounds begin after it",
            Form.amount(Quantity.DURATION)));
    parameters.addAll(List.of(more));
    return List.copyOf(parameters);
  }

  /** Another value of a parameter. */
  private record Variant(Parameter parameter, String value) {}

  /**
   * A primitive's workload as the command line knows it.
   *
   * @param envelope the faults that the primitive tolerates
   * @param timeout the longest one of the protocols
   * @param variants another value of some parameters, for half of the runs with chaos
   * @param preparation adds robots and monitors
   * @param world changes the simulator's default settings
   */
  private record Workload(
      String name,
      String summary,
      Envelope envelope,
      int maxRobots,
      Duration timeout,
      List<Parameter> parameters,
      List<Variant> variants,
      Consumer<Setup> preparation,
      BiConsumer<Request, SimSettings.Builder> world)
      implements Demo {

    Workload(
        String name,
        String summary,
        Envelope envelope,
        int maxRobots,
        Duration timeout,
        List<Parameter> parameters,
        List<Variant> variants,
        Consumer<Setup> preparation) {
      this(
          name,
          summary,
          envelope,
          maxRobots,
          timeout,
          parameters,
          variants,
          preparation,
          (request, settings) -> {});
    }

    @Override
    public Kind kind() {
      return Kind.PRIMITIVE;
    }

    @Override
    public Vocabulary vocabulary(Request request) {
      return VOCABULARY;
    }

    private Course course(Request request) {
      Parameter rounds = parameters.get(0);
      Parameter busy = parameters.get(1);
      return new Course(request.whole(rounds), (long) request.amount(busy) / Time.NS_PER_MS);
    }

    @Override
    public Request varied(Request request) {
      // Fewer of those that take long to simulate.
      Request varied = request.drawRobots(LEAST_DRAWN, Math.min(MOST_DRAWN, 3 * maxRobots / 8));
      long busyMs = course(request).busyMs();
      if (busyMs <= 2 * timeout.toMillis() && busyMs < LONG_MS) {
        long longMs = busyMs + TIMEOUTS * timeout.toMillis();
        String text = Quantities.durationText(longMs * Time.NS_PER_MS);
        varied = varied.drawParameter(parameters.get(1), text);
      }
      for (Variant variant : variants) {
        varied = varied.drawParameter(variant.parameter(), variant.value());
      }
      return varied;
    }

    @Override
    public SimSettings.Builder defaultSettings(Request request) {
      SimSettings.Builder settings =
          SimSettings.builder().set(Setting.CHAOS_FOR, Duration.ofMillis(course(request).busyMs()));
      world.accept(request, settings);
      return settings;
    }

    @Override
    public Plan plan(Request request, SimSettings settings) {
      boolean isChaos = settings.get(Setting.CHAOS) != Envelope.NONE;
      Course given = course(request);
      Course course = new Course(given.rounds(), given.busyMs(), isChaos);
      int robots = request.robots().orElse(DEFAULT_ROBOTS);
      if (robots < 1 || robots > maxRobots) {
        throw new BadInput("robots: " + robots + ": expected 1 to " + maxRobots);
      }
      RoundsStory story = new RoundsStory();
      Simulation.Builder simulation =
          Simulation.builder().settings(settings).timeout(timeout).observer(story);
      preparation.accept(new Setup(request, settings, course, robots, simulation));
      return new Plan(simulation, story, Layer.NONE, simulation.obstacles());
    }
  }
}
