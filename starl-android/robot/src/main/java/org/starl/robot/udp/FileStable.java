package org.starl.robot.udp;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.platform.StableStorage;
import org.starl.platform.Strand;
import org.starl.robot.realtime.Daemons;

/**
 * Stable storage in a directory, one file for each key. A write goes to a new file, which is forced
 * to the disk and then replaces the old one atomically: after a crash a key has either its old or its
 * new value, complete.
 *
 * <p>A failure of the disk is reported once; after it nothing is flushed and no {@code flushed} is
 * called. So the order of writes is kept, and code that waits for a write does not act.
 */
public final class FileStable implements StableStorage, AutoCloseable {

  private static final String FRESH = "fresh.tmp";
  private static final Duration CLOSE_LIMIT = Duration.ofSeconds(10);

  private final Path directory;
  private final Strand strand;
  private final Consumer<IOException> onFailure;
  private final Map<String, byte[]> written = new TreeMap<>();
  private final ExecutorService disk;

  // The disk's thread only.
  private boolean hasFailed;

  private FileStable(Path directory, Strand strand, Consumer<IOException> onFailure) {
    this.directory = directory;
    this.strand = strand;
    this.onFailure = onFailure;
    this.disk = Executors.newSingleThreadExecutor(Daemons.factory(strand + " stable"));
  }

  /**
   * Opens the storage in {@code directory}, which is created if missing; no other robot may use it.
   *
   * @param onFailure is called once, on the storage's thread, when the disk fails
   * @throws IOException if it cannot be read, or contains other files
   */
  public static FileStable open(Path directory, Strand strand, Consumer<IOException> onFailure)
      throws IOException {
    Files.createDirectories(directory);
    FileStable stable = new FileStable(directory, strand, onFailure);
    stable.readAll();
    return stable;
  }

  @Override
  public byte @Nullable [] get(String key) {
    byte[] value = written.get(key);
    return value == null ? null : value.clone();
  }

  @Override
  public void put(String key, byte[] value, Runnable flushed) {
    Path file = file(key);
    byte[] copy = value.clone();
    written.put(key, copy);
    onDisk(() -> replace(file, copy), flushed);
  }

  @Override
  public void remove(String key) {
    Path file = file(key);
    written.remove(key);
    onDisk(() -> Files.deleteIfExists(file), () -> {});
  }

  /** Flushes all writes, and stops. */
  @Override
  public void close() {
    disk.shutdown();
    try {
      if (!disk.awaitTermination(CLOSE_LIMIT.getSeconds(), TimeUnit.SECONDS)) {
        onFailure.accept(new IOException(directory + ": writes are stuck"));
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void readAll() throws IOException {
    try (DirectoryStream<Path> files = Files.newDirectoryStream(directory)) {
      for (Path file : files) {
        String name = String.valueOf(file.getFileName());
        if (name.equals(FRESH)) {
          Files.delete(file);
        } else {
          written.put(StableFiles.key(file), Files.readAllBytes(file));
        }
      }
    }
  }

  private Path file(String key) {
    return directory.resolve(StableFiles.name(key));
  }

  private void onDisk(DiskAction action, Runnable flushed) {
    disk.execute(() -> {
      if (hasFailed) {
        return;
      }
      try {
        action.run();
        forceDirectory();
        strand.post(flushed);
      } catch (IOException e) {
        hasFailed = true;
        onFailure.accept(new IOException(directory + ": cannot be written: " + e, e));
      }
    });
  }

  private void replace(Path file, byte[] value) throws IOException {
    Path fresh = directory.resolve(FRESH);
    try (FileChannel channel =
        FileChannel.open(
            fresh,
            StandardOpenOption.CREATE,
            StandardOpenOption.TRUNCATE_EXISTING,
            StandardOpenOption.WRITE)) {
      ByteBuffer bytes = ByteBuffer.wrap(value);
      while (bytes.hasRemaining()) {
        channel.write(bytes);
      }
      channel.force(true);
    }
    Files.move(fresh, file, StandardCopyOption.ATOMIC_MOVE);
  }

  // Without this a crash may lose the move. Windows cannot do it and does not need it.
  private void forceDirectory() throws IOException {
    if (directory.getFileSystem().getSeparator().equals("/")) {
      try (FileChannel channel = FileChannel.open(directory, StandardOpenOption.READ)) {
        channel.force(true);
      }
    }
  }

  private interface DiskAction {
    void run() throws IOException;
  }
}
