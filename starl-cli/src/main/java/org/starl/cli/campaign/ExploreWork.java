package org.starl.cli.campaign;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Plan;
import org.starl.cli.command.Json;
import org.starl.cli.report.RowJson;
import org.starl.cli.request.RunRequest;
import org.starl.cli.request.Seeds;
import org.starl.input.BadInput;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.explore.Exploration;
import org.starl.sim.explore.Explored;
import org.starl.sim.explore.Explorer;
import org.starl.sim.explore.Order;
import org.starl.sim.explore.Strategy;
import org.starl.sim.fault.Fault;
import org.starl.sim.kernel.CarrierKind;

/**
 * The schedules of an exploration. Drawn ones are split by their numbers. Of an exhaustive search a
 * shard has every so many-th of the first changes, and all that follows them; the first shard has
 * also the run without changes.
 *
 * @param key of all rows
 */
record ExploreWork(RunRequest request, long seed, Exploration exploration, String key)
    implements ShardWork<ScheduleRow> {

  ExploreWork(RunRequest request, long seed, Exploration exploration) {
    this(request, seed, exploration, ShardHeader.key(request, fields(seed, exploration)));
  }

  private static Map<String, Object> fields(long seed, Exploration exploration) {
    return Json.object("seed", seed, "exploration", RowJson.object(exploration));
  }

  @Override
  public String command() {
    return "explore";
  }

  @Override
  public String unit() {
    return "schedule";
  }

  @Override
  public String app() {
    return request.demo().name();
  }

  @Override
  public Map<String, Object> fields() {
    Map<String, Object> fields = Json.object("settings", ShardHeader.settings(request));
    fields.putAll(fields(seed, exploration));
    return fields;
  }

  @Override
  public Seeds.Range numbers() {
    return new Seeds.Range(0, exploration.mostSchedules() - 1);
  }

  @Override
  public boolean isNumbered() {
    return exploration.strategy() != Strategy.EXHAUSTIVE;
  }

  @Override
  public boolean owns(Shard shard, List<Long> place) {
    if (isNumbered()) {
      return ShardWork.super.owns(shard, place);
    }
    return (place.isEmpty() ? 0 : place.getFirst() % shard.count()) == shard.number() - 1;
  }

  @Override
  public ScheduleRow row(String where, String line) {
    ScheduleRow row = RowJson.read(where, line, ScheduleRow.class);
    if (!row.key().equals(key)) {
      throw new BadInput(
          where + "key: " + BadInput.quote(row.key()) + ": expected " + key + ", as in line 1");
    }
    return row;
  }

  @Override
  public String line(ScheduleRow row) {
    return RowJson.line(row);
  }

  @Override
  public List<Long> place(ScheduleRow row) {
    return row.explored().place();
  }

  @Override
  public boolean isGood(ScheduleRow row) {
    return row.explored().outcome().isGood();
  }

  @Override
  public Sequence<ScheduleRow> whole() {
    return isNumbered() ? ShardWork.super.whole() : new Tree();
  }

  /** The places of an exhaustive search: each schedule tells those that follow it. */
  private static final class Tree implements Sequence<ScheduleRow> {
    private final Deque<List<Long>> left = new ArrayDeque<>(List.of(List.of()));

    @Override
    public @Nullable List<Long> next() {
      return left.peek();
    }

    @Override
    public void take(ScheduleRow row) {
      List<Long> place = left.remove();
      for (long i = 0; i < row.explored().next().size(); i++) {
        List<Long> longer = new ArrayList<>(place);
        longer.add(i);
        left.add(List.copyOf(longer));
      }
    }
  }

  @Override
  public String missing(List<Long> expected, @Nullable List<Long> found) {
    if (isNumbered()) {
      return ShardWork.super.missing(expected, found);
    }
    return expected.isEmpty()
        ? "the run without changes is"
        : "schedule "
            + expected.stream().map(String::valueOf).collect(Collectors.joining("."))
            + " is";
  }

  @Override
  public Part<ScheduleRow> part(Shard shard) {
    return part(place -> owns(shard, place));
  }

  @Override
  public Part<ScheduleRow> part(Seeds.Range numbers) {
    return part(place -> numbers.has(place.getFirst()));
  }

  private Part<ScheduleRow> part(Predicate<List<Long>> isOwn) {
    return new Part<>() {
      private final List<Explored> kept = new ArrayList<>();

      @Override
      public boolean keep(ScheduleRow row) {
        kept.add(row.explored());
        return true;
      }

      @Override
      public void run(How how, Predicate<ScheduleRow> isLast) throws InterruptedException {
        try {
          explorer(how).run(isOwn, kept, explored -> isLast.test(new ScheduleRow(key, explored)));
        } catch (IllegalArgumentException e) {
          throw new BadInput("--resume: " + e.getMessage());
        }
      }
    };
  }

  Explorer explorer(How how) {
    return new Explorer(
        exploration,
        (schedule, order) -> run(schedule, order, how.carriers()),
        how.workers(),
        (finished, planned) -> how.progress().advanced(finished, planned, 0));
  }

  private RunOutcome run(List<Fault> schedule, Order order, CarrierKind carriers) {
    Plan plan = SeedRuns.plan(request.withFaults(schedule), seed, carriers);
    plan.simulation().observer(order);
    return RunOutcome.of(plan.simulation().build().run());
  }
}
