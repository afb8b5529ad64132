package org.starl.cli.campaign;

import static java.util.stream.Collectors.toCollection;

import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Demos;
import org.starl.cli.command.Json;
import org.starl.cli.report.SeedRow;
import org.starl.cli.report.SweepTable;
import org.starl.cli.request.RunRequest;
import org.starl.cli.request.Seeds;
import org.starl.input.BadInput;
import org.starl.sim.check.Campaign;

/**
 * The runs of a campaign, or of a sweep: each point runs with each seed. A run's number is its seed
 * in a campaign. In a sweep it counts from 1, and first come all points with the first seed.
 *
 * @param points of a sweep; one in a campaign
 * @param keys of the points, as rows have them
 * @param sweep null for a campaign
 */
public record SeedWork(
    List<RunRequest> points,
    Seeds.Range seeds,
    Ending ending,
    List<String> keys,
    @Nullable SweepFile sweep)
    implements ShardWork<SeedRow> {

  public static SeedWork campaign(RunRequest request, Seeds.Range seeds, Ending ending) {
    return new SeedWork(
        List.of(request), seeds, ending, List.of(ShardHeader.key(request, Map.of())), null);
  }

  /**
   * The runs of a sweep.
   *
   * @throws BadInput naming the file's line, the key, the value and the expected form
   */
  public static SeedWork sweep(SweepFile file, Demos demos) {
    List<RunRequest> points =
        file.points().stream().map(point -> file.request(demos, point)).toList();
    List<String> keys = points.stream().map(request -> ShardHeader.key(request, Map.of())).toList();
    return new SeedWork(points, file.seeds(), Ending.NEVER, keys, file);
  }

  @Override
  public String command() {
    return sweep == null ? "campaign" : "sweep";
  }

  @Override
  public String unit() {
    return sweep == null ? "seed" : "run";
  }

  @Override
  public Map<String, Object> fields() {
    return sweep != null
        ? Json.object("file", sweep.scenario().file(), "text", sweep.text())
        : Json.object(
            "settings", ShardHeader.settings(points.getFirst()),
            "seeds", seeds.toString(),
            "stop", ending.stops(),
            "until", ending.untilText());
  }

  private long firstNumber() {
    return sweep == null ? seeds.first() : 1;
  }

  @Override
  public String app() {
    return points.getFirst().demo().name();
  }

  @Override
  public Seeds.Range numbers() {
    return new Seeds.Range(firstNumber(), firstNumber() + points.size() * seeds.size() - 1);
  }

  int point(long number) {
    return (int) ((number - firstNumber()) % points.size());
  }

  private SeedRuns.One one(long number) {
    int point = point(number);
    return new SeedRuns.One(points.get(point), keys.get(point), point, seed(number));
  }

  long seed(long number) {
    return seeds.first() + (number - firstNumber()) / points.size();
  }

  @Override
  public SeedRow row(String where, String line) {
    SeedRow row = SeedRow.of(where, line);
    if (row.point() < 0 || row.point() >= points.size()) {
      throw new BadInput(
          where + "point: " + row.point() + ": expected one of " + points.size() + ", from 0");
    }
    String key = keys.get(row.point());
    if (!row.key().equals(key)) {
      throw new BadInput(
          where + "key: " + BadInput.quote(row.key()) + ": expected " + key + ", as in line 1");
    }
    return row;
  }

  @Override
  public String line(SeedRow row) {
    return row.line();
  }

  @Override
  public List<Long> place(SeedRow row) {
    return List.of(firstNumber() + (row.seed() - seeds.first()) * points.size() + row.point());
  }

  @Override
  public boolean isGood(SeedRow row) {
    return row.outcome().isGood();
  }

  @Override
  public Part<SeedRow> part(Shard shard) {
    Part<SeedRow> part = part(shard.seeds(numbers()));
    return new Part<>() {
      @Override
      public boolean keep(SeedRow row) {
        return part.keep(row);
      }

      @Override
      public void run(How how, Predicate<SeedRow> isLast) throws InterruptedException {
        part.run(how, checked(isLast));
      }
    };
  }

  /**
   * Passes rows on, and checks the measures that a sweep is to show as soon as each point has run.
   *
   * @return a predicate that throws {@link BadInput} if no point has one of the measures
   */
  Predicate<SeedRow> checked(Predicate<SeedRow> isLast) {
    if (sweep == null) {
      return isLast;
    }
    SweepFile file = sweep;
    return new Predicate<>() {
      private final SortedSet<String> measures = new TreeSet<>();
      private int left = points.size();

      @Override
      public boolean test(SeedRow row) {
        if (left > 0) {
          measures.addAll(SweepTable.measuresOf(row).keySet());
          left--;
          if (left == 0) {
            file.requireShown(measures);
          }
        }
        return isLast.test(row);
      }
    };
  }

  @Override
  public Part<SeedRow> part(Seeds.Range numbers) {
    return new Part<>() {
      private long next = numbers.first();
      private boolean isOver;

      @Override
      public boolean keep(SeedRow row) {
        isOver |= ending.stops() && !isGood(row);
        return place(row).equals(List.of(next++));
      }

      @Override
      public void run(How how, Predicate<SeedRow> isLast) throws InterruptedException {
        if (!isOver && next <= numbers.last()) {
          runSeeds(new Seeds.Range(next, numbers.last()), how, sweep == null, isLast);
        }
      }
    };
  }

  /**
   * Runs these numbers.
   *
   * @param countsMessages whether rows have the messages by channel, which only a campaign's report
   *     shows
   */
  public void runSeeds(Seeds.Range part, How how, boolean countsMessages, Predicate<SeedRow> isLast)
      throws InterruptedException {
    Campaign campaign = new Campaign(part.first(), part.last(), how.workers(), ending.stops());
    Campaign.Progress progress =
        new Campaign.Progress() {
          @Override
          public void advanced(long finished, long planned, long bad) {
            how.progress().advanced(finished, planned, bad);
          }

          @Override
          public void running(SortedSet<Long> numbers) {
            how.progress()
                .running(
                    numbers.stream().map(SeedWork.this::seed).collect(toCollection(TreeSet::new)));
          }
        };
    new SeedRuns(this::one, how.carriers(), countsMessages).run(campaign, progress, isLast);
  }
}
