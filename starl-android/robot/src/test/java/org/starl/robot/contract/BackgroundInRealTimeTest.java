package org.starl.robot.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.starl.platform.Background;
import org.starl.platform.Strand;
import org.starl.robot.realtime.RealBackground;

class BackgroundInRealTimeTest extends BackgroundContract {

  private RealBackground background;

  @Override
  protected Ground newGround() {
    return new RealGround("robot0");
  }

  @Override
  protected Background newBackground(Ground on) {
    background = new RealBackground("robot0", on.strand());
    return background;
  }

  @AfterEach
  void endWorker() {
    background.close();
  }

  @Test
  void theStrandContinuesWhileATaskRuns() {
    try (RealGround ground = new RealGround("robot1");
        RealBackground own = new RealBackground("robot1", ground.strand())) {
      CountDownLatch goOn = new CountDownLatch(1);
      CountDownLatch over = new CountDownLatch(1);
      Strand strand = ground.strand();
      strand.post(() -> {
        own.submit(() -> awaitOpen(goOn), over::countDown);
        strand.post(goOn::countDown);
      });
      ground.runUntil(over);
      assertThat(ground.errors()).isEmpty();
    }
  }

  private static void awaitOpen(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      throw new IllegalStateException("interrupted", e);
    }
  }
}
