package org.starl.spark;

import java.io.IOException;
import java.io.Serializable;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.apache.spark.SimpleFutureAction;
import org.apache.spark.api.java.JavaRDD;
import org.jspecify.annotations.Nullable;
import org.starl.cli.campaign.CampaignEngine.Rows;
import org.starl.cli.campaign.SeedPart;
import scala.collection.Iterator;
import scala.collection.immutable.Range$;
import scala.runtime.AbstractFunction0;
import scala.runtime.AbstractFunction1;
import scala.runtime.AbstractFunction2;
import scala.runtime.BoxedUnit;
import scala.util.Try;

/** A job of Spark whose driver takes the result of each task as soon as the task has ended. */
final class PartsJob {

  /** A part's index and its lines, or the end of the job if {@code lines} is null. */
  private record Finished(int part, @Nullable List<String> lines) {}

  /** The one element of a partition, the lines of its part. */
  private static final class Lines extends AbstractFunction1<Iterator<List<String>>, List<String>>
      implements Serializable {

    private static final long serialVersionUID = 1;

    @Override
    public List<String> apply(Iterator<List<String>> partition) {
      return partition.next();
    }
  }

  private final JavaRDD<List<String>> lines;
  private final List<SeedPart> parts;
  private final BlockingQueue<Finished> finished = new LinkedBlockingQueue<>();

  /**
   * @param lines a partition for each of {@code parts}, with one element
   */
  PartsJob(JavaRDD<List<String>> lines, List<SeedPart> parts) {
    this.lines = lines;
    this.parts = parts;
  }

  /**
   * Runs all parts, or until {@code rows} are decided.
   *
   * @throws IOException if a part fails repeatedly
   */
  void run(Rows rows) throws InterruptedException, IOException {
    SimpleFutureAction<BoxedUnit> job = submit();
    // Spark calls from its own threads; the queue makes the rows this thread's.
    job.onComplete(
        new AbstractFunction1<Try<BoxedUnit>, BoxedUnit>() {
          @Override
          public BoxedUnit apply(Try<BoxedUnit> any) {
            finished.add(new Finished(-1, null));
            return BoxedUnit.UNIT;
          }
        },
        scala.concurrent.ExecutionContext.global());
    try {
      for (Finished part = finished.take(); part.lines != null; part = finished.take()) {
        if (rows.take(parts.get(part.part), part.lines)) {
          return;
        }
      }
      Try<BoxedUnit> result = job.value().get();
      if (result.isFailure()) {
        throw SparkEngine.failed(result.failed().get());
      }
    } finally {
      job.cancel();
    }
  }

  private SimpleFutureAction<BoxedUnit> submit() {
    return lines
        .rdd()
        .sparkContext()
        .submitJob(
            lines.rdd(),
            new Lines(),
            Range$.MODULE$.apply(0, parts.size()),
            new AbstractFunction2<Object, List<String>, BoxedUnit>() {
              @Override
              public BoxedUnit apply(Object part, List<String> result) {
                finished.add(new Finished((Integer) part, result));
                return BoxedUnit.UNIT;
              }
            },
            new AbstractFunction0<BoxedUnit>() {
              @Override
              public BoxedUnit apply() {
                return BoxedUnit.UNIT;
              }
            });
  }
}
