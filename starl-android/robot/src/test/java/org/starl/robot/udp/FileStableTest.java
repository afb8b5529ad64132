package org.starl.robot.udp;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.platform.StableStorage;
import org.starl.robot.contract.Ground;
import org.starl.robot.contract.RealGround;
import org.starl.robot.contract.StableContract;

/** Files: the contract, and what only a disk can do. */
class FileStableTest extends StableContract {

  @TempDir private Path directory;
  private final List<FileStable> stables = new ArrayList<>();

  /** Before the folder goes: a disk's thread that still writes would put files into it. */
  @AfterEach
  void closeAll() {
    stables.forEach(FileStable::close);
  }

  @Override
  protected Ground newGround() {
    return new RealGround("robot0");
  }

  @Override
  protected StableStorage open(Ground ground) {
    return open(ground, ground.errors()::add);
  }

  // A thread cannot be killed as a crash would: this crash comes right after the last flush.
  @Override
  protected StableStorage crashAndReopen(Ground ground) {
    stables.get(stables.size() - 1).close();
    return open(ground);
  }

  @Test
  void aTruncatedWriteIsIgnored() throws IOException {
    Files.createDirectories(directory.resolve("robot0"));
    Files.write(directory.resolve("robot0/fresh.tmp"), new byte[] {1, 2});
    Files.write(directory.resolve("robot0/starl.boot.value"), new byte[] {7});
    try (RealGround ground = new RealGround("robot0");
        FileStable opened = open(ground, ground.errors()::add)) {
      assertThat(opened.get("starl.boot")).containsExactly(7);
      assertThat(directory.resolve("robot0")).isDirectoryNotContaining("glob:**fresh.tmp");
    }
  }

  @Test
  void theErrorNamesAForeignFile() throws IOException {
    Files.createDirectories(directory.resolve("robot0"));
    for (String name : List.of("holiday.jpg", "Capital.value", ".value", "a%zz.value", "%.value")) {
      Path file = Files.write(directory.resolve("robot0").resolve(name), new byte[0]);
      try (RealGround ground = new RealGround("robot0")) {
        assertThatThrownBy(
                () -> FileStable.open(directory.resolve("robot0"), ground.strand(), e -> {}))
            .isInstanceOf(IOException.class)
            .hasMessageContaining(name);
      }
      Files.delete(file);
    }
  }

  @Test
  void aKeyThatIsNoValidFileNameIsABug() {
    try (RealGround ground = new RealGround("robot0");
        FileStable opened = open(ground, ground.errors()::add)) {
      assertThatThrownBy(() -> opened.put("", new byte[0], () -> {}))
          .isInstanceOf(IllegalArgumentException.class);
      assertThatThrownBy(() -> opened.put("x".repeat(300), new byte[0], () -> {}))
          .isInstanceOf(IllegalArgumentException.class);
    }
  }

  @Test
  void aDiskFailureIsReportedOnceAndEndsFlushing() throws IOException {
    List<Throwable> failures = new CopyOnWriteArrayList<>();
    List<String> log = new CopyOnWriteArrayList<>();
    CountDownLatch failed = new CountDownLatch(1);
    try (RealGround ground = new RealGround("robot0")) {
      FileStable opened =
          open(
              ground,
              e -> {
                failures.add(e);
                failed.countDown();
              });
      Path own = directory.resolve("robot0");
      Files.delete(own);
      opened.put("a", new byte[] {1}, () -> log.add("a flushed"));
      ground.runUntil(failed);
      Files.createDirectories(own);
      opened.put("b", new byte[] {1}, () -> log.add("b flushed"));
      opened.close();
      assertThat(opened.get("b")).containsExactly(1);
      assertThat(own).isEmptyDirectory();
    }
    assertThat(failures).hasSize(1);
    assertThat(log).isEmpty();
  }

  @Test
  void aFullDiskIsReportedWithItsFolder() throws IOException {
    CountDownLatch failed = new CountDownLatch(1);
    List<Throwable> failures = new CopyOnWriteArrayList<>();
    try (RealGround ground = new RealGround("robot0")) {
      FileStable opened =
          open(
              ground,
              e -> {
                failures.add(e);
                failed.countDown();
              });
      Path own = directory.resolve("robot0");
      Files.createSymbolicLink(own.resolve("fresh.tmp"), Path.of("/dev/full"));
      List<String> log = new CopyOnWriteArrayList<>();
      opened.put("a", new byte[] {1}, () -> log.add("a flushed"));
      ground.runUntil(failed);
      opened.close();
      assertThat(failures)
          .singleElement()
          .asString()
          .contains(own + ": cannot be written")
          .contains("No space left");
      assertThat(log).isEmpty();
    }
  }

  @Test
  void closingFlushesPendingWrites() {
    try (RealGround ground = new RealGround("robot0")) {
      FileStable opened = open(ground, ground.errors()::add);
      for (int i = 0; i < 50; i++) {
        opened.put("key" + i, new byte[] {(byte) i}, () -> {});
      }
      opened.close();
      try (FileStable next = open(ground, ground.errors()::add)) {
        assertThat(next.get("key49")).containsExactly(49);
      }
    }
  }

  private FileStable open(Ground ground, Consumer<IOException> onFailure) {
    try {
      FileStable stable = FileStable.open(directory.resolve("robot0"), ground.strand(), onFailure);
      stables.add(stable);
      return stable;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
