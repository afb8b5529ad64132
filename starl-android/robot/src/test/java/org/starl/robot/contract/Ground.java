package org.starl.robot.contract;

import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.starl.platform.Clock;
import org.starl.platform.Strand;
import org.starl.platform.Timers;

/** A robot's strand, simulated or real, and how a test lets it run. */
public interface Ground extends AutoCloseable {

  Clock clock();

  Strand strand();

  Timers timers();

  /** Ends the strand's run and its app, from outside or from a piece. */
  void closeStrand();

  /** Lets time pass until {@code done} is open; fails after long, or when nothing can open it. */
  void runUntil(CountDownLatch done);

  /** Lets time pass until something has come out of a piece or of the app. */
  void runUntilError();

  /** What came out of pieces and of the app so far, unless {@link #runUntil} has thrown it. */
  List<Throwable> errors();

  @Override
  void close();
}
