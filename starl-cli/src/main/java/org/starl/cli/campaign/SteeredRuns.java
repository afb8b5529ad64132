package org.starl.cli.campaign;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.cli.campaign.CampaignCommand.FirstBad;
import org.starl.cli.report.SeedRow;
import org.starl.cli.request.RunRequest;
import org.starl.random.Rng;
import org.starl.sim.Redraws;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.check.Campaign;
import org.starl.sim.fault.Envelope;
import org.starl.sim.kernel.CarrierKind;
import org.starl.time.Time;

/**
 * Further runs of a campaign, near what few of its seeds reached. Each repeats a run that reached a rare
 * part of the theories and protocols, and draws other random numbers from some time on. The faults
 * stay, but meet other states. Which runs these are depends on the campaign's rows alone.
 */
final class SteeredRuns {

  /** A campaign with chaos has one such run for so many seeds, up to {@link #MOST}. */
  private static final int SEEDS_A_RUN = 2;

  private static final int MOST = 500;

  private final List<SeedRuns.One> runs = new ArrayList<>();
  private final CampaignTally tally = new CampaignTally(false);
  private @Nullable FirstBad firstBad;

  /**
   * @param request of the campaign
   * @param key of its rows
   * @param seeds its tally, of all its rows
   */
  SteeredRuns(RunRequest request, String key, CampaignTally seeds, CarrierKind carriers) {
    boolean isSteered = seeds.bad() == 0 && mayFollow(request);
    int count = isSteered ? (int) Math.min(MOST, seeds.runs() / SEEDS_A_RUN) : 0;
    Rng rng = new Rng(seeds.runs());
    Map<Long, Long> chaosEndsMs = new TreeMap<>();
    for (long seed : seeds.rareParts().seeds(count)) {
      // Later there are no faults. Few seeds make many runs.
      long endMs = chaosEndsMs.computeIfAbsent(seed, same -> chaosEndMs(request, same, carriers));
      long atMs = rng.nextLong(0, endMs);
      Redraws.One redraw = new Redraws.One(atMs * Time.NS_PER_MS, runs.size() + 1);
      runs.add(new SeedRuns.One(request.with(Redraws.NONE.plus(redraw)), key, 0, seed));
    }
  }

  /** Whether a campaign of this request goes on with such runs, if no run is bad. */
  static boolean mayFollow(RunRequest request) {
    return request.settings().get(Setting.CHAOS) != Envelope.NONE;
  }

  private static long chaosEndMs(RunRequest request, long seed, CarrierKind carriers) {
    SimSettings settings = SeedRuns.plan(request, seed, carriers).simulation().settings();
    return settings.chaosEndNs() / Time.NS_PER_MS;
  }

  /** Runs them, and adds what they reached to the coverage of {@code seeds}. */
  void run(CampaignTally seeds, CarrierKind carriers, int workers, Campaign.Progress progress)
      throws InterruptedException {
    if (runs.isEmpty()) {
      return;
    }
    new SeedRuns(number -> runs.get((int) number), carriers, false)
        .run(new Campaign(0, runs.size() - 1, workers, false), progress, this::add);
    seeds.coverage().add(tally.coverage());
  }

  private boolean add(SeedRow row) {
    if (firstBad == null && !row.outcome().isGood()) {
      firstBad = new FirstBad(runs.get((int) tally.runs()).request(), row);
    }
    tally.add(row);
    return false;
  }

  @Nullable FirstBad firstBad() {
    return firstBad;
  }

  /** A line that tells how many there were; none if there were none. */
  List<String> lines() {
    return runs.isEmpty()
        ? List.of()
        : List.of(
            "steered: %d further runs near what few seeds reached, %d bad"
                .formatted(tally.runs(), tally.bad()));
  }

  /** The same, and the first bad one. */
  List<String> story() {
    List<String> story = new ArrayList<>(lines());
    if (firstBad != null) {
      story.add(firstBad.line());
    }
    return story;
  }

  /** The command of the first bad one; empty if there is none. */
  String replay() {
    return firstBad == null ? "" : firstBad.request().replay(firstBad.row().seed());
  }

  /** Empty if there were none. */
  Map<String, Object> json() {
    Map<String, Object> json = new LinkedHashMap<>();
    if (!runs.isEmpty()) {
      json.put("steered_runs", tally.runs());
      json.put("steered_bad", tally.bad());
    }
    if (firstBad != null) {
      json.put("steered_first_bad", firstBad.row().outcome().detail());
      json.put("steered_replay", firstBad.replay());
    }
    return json;
  }
}
