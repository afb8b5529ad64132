package org.starl.cli.serve;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Demos;
import org.starl.apps.Plan;
import org.starl.cli.command.Json;
import org.starl.cli.command.OptionValues;
import org.starl.cli.report.SeedRow;
import org.starl.cli.request.RunRequest;
import org.starl.cli.run.Viewing;
import org.starl.cli.schema.ScenarioSchema;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.robot.realtime.Daemons;
import org.starl.sim.check.RunOutcome.Verdict;
import org.starl.sim.kernel.CarrierKind;
import org.starl.sim.replay.LiveRun;
import org.starl.sim.replay.Recording;
import org.starl.sim.view.ViewSettings;
import org.starl.sim.view.page.LivePage;
import org.starl.time.Time;

/** The runs of {@code starl serve}, and its campaign. Thread-safe. */
final class LiveSite implements Site, AutoCloseable {

  /** The oldest run that is over goes when another one starts. */
  private static final int MOST_RUNS = 12;

  /** Runs that a browser starts; each takes a core. */
  private static final int MOST_AT_ONCE = 4;

  /** Of the campaign's bad runs, and of the squares for its first runs. */
  private static final int MOST_BAD = 100;

  private static final int MOST_SQUARES = 5_000;
  private static final long TICK_MS = 20;

  private record Kept(Shown shown, @Nullable LiveRun live) {
    boolean isOver() {
      return shown.recording().isOver();
    }
  }

  private final Demos demos;
  private final Home home;
  private final CarrierKind carriers;
  private final Map<Integer, Kept> runs = new LinkedHashMap<>();
  private final ScheduledExecutorService clock =
      Executors.newSingleThreadScheduledExecutor(Daemons.factory("pace"));
  private int lastNumber;

  /** Runs that browsers start, and that are not among the runs yet. */
  private int planning;

  // Of the campaign.
  private @Nullable RunRequest campaign;
  private long planned;
  private long done;
  private long bad;
  private boolean isEnded;
  private final StringBuilder verdicts = new StringBuilder();
  private final List<Map<String, Object>> badRows = new ArrayList<>();

  LiveSite(Demos demos, Home home, CarrierKind carriers) {
    this.demos = demos;
    this.home = home;
    this.carriers = carriers;
  }

  @Override
  public Home home() {
    return home;
  }

  @Override
  public synchronized @Nullable Shown run(int number) {
    Kept kept = runs.get(number);
    return kept == null ? null : kept.shown;
  }

  /** Adds a run that is recorded elsewhere; returns its number. */
  synchronized int add(Shown shown) {
    runs.put(++lastNumber, new Kept(shown, null));
    return lastNumber;
  }

  /**
   * Starts a simulation.
   *
   * @param isPaced whether it goes on at the speed of its settings; else as fast as it can
   */
  int start(RunRequest request, long seed, Plan plan, boolean isPaced) {
    Recording recording = Viewing.recording(plan);
    plan.simulation().carriers(carriers);
    LiveRun live = new LiveRun(plan.simulation(), recording);
    double speed = isPaced ? ViewSettings.speed(request.settings()) : 0;
    LivePage page = new LivePage(recording, speed);
    String title = request.demo().name() + ", seed " + seed;
    Shown shown = new Shown(title, request.replay(seed), recording, page);
    live.start();
    if (speed > 0) {
      pace(live, speed);
    } else {
      live.runUntil(Long.MAX_VALUE);
    }
    synchronized (this) {
      makeRoom();
      runs.put(++lastNumber, new Kept(shown, live));
      return lastNumber;
    }
  }

  private void pace(LiveRun live, double speed) {
    long tickNs = (long) (TICK_MS * Time.NS_PER_MS * speed);
    long[] limitNs = new long[1];
    Runnable tick =
        () -> {
          limitNs[0] += tickNs;
          live.runUntil(limitNs[0]);
        };
    Future<?> unused = clock.scheduleAtFixedRate(tick, 0, TICK_MS, TimeUnit.MILLISECONDS);
  }

  @Override
  public int start(Map<String, ?> wanted) {
    if (home == Home.RUN) {
      throw new BadInput("this server shows one run; expected 'starl serve' for a playground");
    }
    long seed =
        OptionValues.read(
            "seed",
            text(wanted, "seed"),
            text -> Quantities.whole(text, Long.MIN_VALUE, Long.MAX_VALUE));
    RunRequest known = campaign();
    RunRequest request = known == null ? request(wanted) : known;
    enter();
    try {
      // Planning may read long files: other browsers do not wait for it.
      Plan plan = request.plan(seed);
      plan.simulation().build();
      return start(request, seed, plan, false);
    } finally {
      leave();
    }
  }

  private synchronized @Nullable RunRequest campaign() {
    return campaign;
  }

  private synchronized void enter() {
    long running = runs.values().stream().filter(run -> !run.isOver()).count();
    if (running + planning >= MOST_AT_ONCE) {
      throw new BadInput(MOST_AT_ONCE + " runs go on; expected one of them to end first");
    }
    planning++;
  }

  private synchronized void leave() {
    planning--;
  }

  /** Forgets the oldest run that is over, if there are too many. */
  private void makeRoom() {
    List<Integer> over =
        runs.keySet().stream().filter(n -> Objects.requireNonNull(runs.get(n)).isOver()).toList();
    if (runs.size() >= MOST_RUNS && !over.isEmpty()) {
      runs.remove(over.get(0));
    }
  }

  private RunRequest request(Map<String, ?> wanted) {
    RunRequest.Builder request =
        RunRequest.Builder.of(demos, text(wanted, "app"), "app: ", "; see 'starl list'");
    if (wanted.get("set") instanceof Map<?, ?> values) {
      values.forEach((key, value) -> request.set("", String.valueOf(key), String.valueOf(value)));
    }
    if (wanted.get("faults") instanceof Collection<?> faults) {
      faults.forEach(fault -> request.fault(String.valueOf(fault)));
    }
    return request.build();
  }

  private static String text(Map<String, ?> wanted, String key) {
    Object value = wanted.get(key);
    if (value == null) {
      throw new BadInput(key + ": missing; expected a request with app, seed, set, faults");
    }
    return value.toString();
  }

  /** Begins a campaign of so many runs. */
  synchronized void begin(RunRequest request, long count) {
    campaign = request;
    planned = count;
  }

  /** Takes the next run of the campaign. */
  synchronized void add(SeedRow row) {
    boolean isGood = row.outcome().isGood();
    if (verdicts.length() < MOST_SQUARES) {
      verdicts.append(sign(row.outcome().verdict()));
    }
    done++;
    if (!isGood) {
      bad++;
      if (badRows.size() < MOST_BAD && campaign != null) {
        badRows.add(
            Json.object(
                "seed", row.seed(),
                "detail", row.outcome().detail(),
                "replay", campaign.replay(row.seed())));
      }
    }
  }

  private static char sign(Verdict verdict) {
    return switch (verdict) {
      case GOOD -> 'g';
      case VIOLATED -> 'v';
      default -> 'b';
    };
  }

  synchronized void endCampaign() {
    isEnded = true;
  }

  @Override
  public synchronized Map<String, Object> overview() {
    List<Object> listed = new ArrayList<>();
    runs.forEach((number, kept) ->
        listed.add(
            Json.object(
                "number", number,
                "title", kept.shown.title(),
                "command", kept.shown.command(),
                "state", kept.shown.page().state())));
    Map<String, Object> overview = Json.object("runs", listed);
    RunRequest of = campaign;
    if (of != null) {
      overview.put(
          "campaign",
          Json.object(
              "app", of.demo().name(),
              "planned", planned,
              "done", done,
              "bad", bad,
              "isEnded", isEnded,
              "verdicts", verdicts.toString(),
              "rows", List.copyOf(badRows)));
    }
    return overview;
  }

  @Override
  public Map<String, Object> schema() {
    return ScenarioSchema.json(demos);
  }

  /** Waits until the calling thread is interrupted. */
  synchronized void await() throws InterruptedException {
    while (!clock.isShutdown()) {
      wait();
    }
  }

  @Override
  public void close() {
    clock.shutdownNow();
    List<Kept> all;
    synchronized (this) {
      all = List.copyOf(runs.values());
    }
    all.forEach(kept -> {
      if (kept.live != null) {
        kept.live.close();
      }
    });
  }
}
