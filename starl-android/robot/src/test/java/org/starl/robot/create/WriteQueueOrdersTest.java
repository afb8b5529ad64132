package org.starl.robot.create;

import java.io.ByteArrayOutputStream;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.concurrent.CountDownLatch;
import org.jetbrains.lincheck.Lincheck;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * The queue under a scheduler that chooses the order of its threads' steps (Lincheck): random orders,
 * the same in each run of the test.
 */
@Tag("long")
class WriteQueueOrdersTest {

  private static final int ORDERS = 500;

  /** A link without bytes, which must stay open. */
  private static final class NoLink implements ByteLink {
    @Override
    public InputStream input() {
      return InputStream.nullInputStream();
    }

    @Override
    public OutputStream output() {
      return OutputStream.nullOutputStream();
    }

    @Override
    public void close() {
      throw new IllegalStateException("the writer gave up");
    }
  }

  private static final class Written extends ByteArrayOutputStream {
    private final CountDownLatch first = new CountDownLatch(1);

    @Override
    public void flush() {
      first.countDown();
    }

    void awaitFirst() {
      try {
        first.await();
      } catch (InterruptedException e) {
        throw new IllegalStateException(e);
      }
    }
  }

  @Test
  void eachAcceptedByteIsWrittenOnceAndTheWriterEnds() {
    Lincheck.runConcurrentTest(
        ORDERS,
        () -> {
          WriteQueue queue = new WriteQueue(2);
          Written written = new Written();
          Thread writer = new Thread(() -> queue.writeTo(written, new NoLink()));
          int[] accepted = {0};
          Thread driver =
              new Thread(() -> {
                for (byte i = 1; i <= 3; i++) {
                  accepted[0] += queue.offer(new byte[] {i}) ? 1 : 0;
                }
                written.awaitFirst();
                queue.close();
              });
          writer.start();
          driver.start();
          try {
            driver.join();
            writer.join();
          } catch (InterruptedException e) {
            throw new IllegalStateException(e);
          }
          byte[] bytes = written.toByteArray();
          for (int i = 1; i < bytes.length; i++) {
            if (bytes[i] <= bytes[i - 1]) {
              throw new IllegalStateException("out of order");
            }
          }
          if (bytes.length != accepted[0] || accepted[0] < 2) {
            throw new IllegalStateException(bytes.length + " of " + accepted[0] + " written");
          }
        });
  }

  @Test
  void theNewestSpeedIsAlwaysWritten() {
    Lincheck.runConcurrentTest(
        ORDERS,
        () -> {
          WriteQueue queue = new WriteQueue(2);
          ByteArrayOutputStream written = new ByteArrayOutputStream();
          Thread writer = new Thread(() -> queue.writeTo(written, new NoLink()));
          writer.start();
          for (byte i = 1; i <= 3; i++) {
            if (!queue.offerNewest(new byte[] {i})) {
              throw new IllegalStateException("refused " + i);
            }
          }
          queue.close();
          try {
            writer.join();
          } catch (InterruptedException e) {
            throw new IllegalStateException(e);
          }
          byte[] bytes = written.toByteArray();
          if (bytes.length == 0 || bytes[bytes.length - 1] != 3) {
            throw new IllegalStateException("the newest speed is lost");
          }
        });
  }
}
