package org.starl.cli.campaign;

import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.starl.cli.request.Seeds;
import org.starl.sim.check.Campaign;
import org.starl.sim.kernel.CarrierKind;

/**
 * The runs that shards have parts of: those of a campaign, a sweep or an exploration.
 *
 * @param <R> what is kept of each run, a row of a shard's file. A row has a place, one number or
 *     several. Rows are in the order of their places: shorter ones first, then by their numbers
 */
public interface ShardWork<R> {

  /** The command that makes the files: {@code campaign}, {@code sweep} or {@code explore}. */
  String command();

  /** One row in messages: {@code seed}. */
  String unit();

  String app();

  /** What decides the runs, besides version and app, by the names of the header's fields. */
  Map<String, Object> fields();

  /** The places of all rows, if each is one number; else the first number has no meaning. */
  Seeds.Range numbers();

  /** Whether each place is one of {@link #numbers}. */
  default boolean isNumbered() {
    return true;
  }

  /** Whether the row of a place is in the file of this shard. */
  default boolean owns(Shard shard, List<Long> place) {
    return shard.seeds(numbers()).has(place.getFirst());
  }

  /**
   * The row of a line.
   *
   * @param where the place of the line, for errors
   * @throws org.starl.input.BadInput if it is none, or of other settings
   */
  R row(String where, String line);

  String line(R row);

  List<Long> place(R row);

  boolean isGood(R row);

  /** The places that the rows of all shards have, in order. */
  default Sequence<R> whole() {
    Seeds.Range numbers = numbers();
    return new Sequence<>() {
      private long next = numbers.first();

      @Override
      public @Nullable List<Long> next() {
        return next > numbers.last() ? null : List.of(next);
      }

      @Override
      public void take(R row) {
        next++;
      }
    };
  }

  /** The places of rows, each known when the rows before it are. */
  interface Sequence<R> {

    /** The place of the next row; null at the end. */
    @Nullable List<Long> next();

    /** Takes the row of {@link #next}. */
    void take(R row);
  }

  /** The part of one process. */
  interface Part<R> {

    /** Takes a row of an earlier process; false if a row before it is missing. */
    boolean keep(R row);

    /**
     * Runs the rest.
     *
     * @param isLast gets each row in order; after the first true the part ends
     */
    void run(How how, Predicate<R> isLast) throws InterruptedException;
  }

  /**
   * How to run.
   *
   * @param workers threads
   */
  record How(CarrierKind carriers, int workers, Campaign.Progress progress) {}

  Part<R> part(Shard shard);

  /** The part that has these numbers; only if the work is numbered. */
  Part<R> part(Seeds.Range numbers);

  /**
   * Which rows are missing: {@code seeds 4..6 of 1..9 are}.
   *
   * @param found the place of the row after the gap; null at the end
   */
  default String missing(List<Long> expected, @Nullable List<Long> found) {
    Seeds.Range all = numbers();
    long first = expected.getFirst();
    long last = found == null ? all.last() : found.getFirst() - 1;
    return first == last
        ? unit() + " " + first + " of " + all + " is"
        : unit() + "s " + first + ".." + last + " of " + all + " are";
  }
}
