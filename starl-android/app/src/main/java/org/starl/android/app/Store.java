package org.starl.android.app;

import android.content.Context;
import android.content.SharedPreferences;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import java.util.Collection;
import java.util.EnumSet;
import java.util.Locale;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.DeploymentReader;
import org.starl.robot.file.Positions;
import org.starl.robot.udp.KeyFile;
import org.starl.robot.udp.PeerKeys;
import org.starl.robot.udp.RobotKey;

/** The files that the user loaded, in the app's own folder, which no other app can read. */
final class Store {

  /** The kinds of files that can be loaded. */
  enum Item {
    DEPLOYMENT("deployment.yaml", 1 << 20),
    KEY("deployment.key", 1 << 10);

    final String file;
    final int maxBytes;

    Item(String file, int maxBytes) {
      this.file = file;
      this.maxBytes = maxBytes;
    }
  }

  private static final String PREFERENCES = "robot";
  private static final String NAME = "name";
  private static final String EMERGENCY = "emergency";
  private static final String APP = "app";
  private static final String TRACE = ".trace";
  private static final int KEPT_TRACES = 20;

  private final Path folder;
  private final SharedPreferences preferences;

  Store(Context context) {
    folder = context.getFilesDir().toPath();
    preferences = context.getSharedPreferences(PREFERENCES, Context.MODE_PRIVATE);
  }

  /** The robot of this phone; empty if not selected. */
  String robotName() {
    return String.valueOf(preferences.getString(NAME, ""));
  }

  void setRobotName(String name) {
    preferences.edit().putString(NAME, name).apply();
  }

  /** Whether the emergency stop was pressed and not released, in this or an earlier process. */
  boolean isEmergency() {
    return preferences.getBoolean(EMERGENCY, false);
  }

  /** Returns when it is on the disk; false if it could not be written. */
  boolean setEmergency(boolean isOn) {
    return preferences.edit().putBoolean(EMERGENCY, isOn).commit();
  }

  /** The app that was chosen for a deployment without one; empty if none. */
  String app() {
    return String.valueOf(preferences.getString(APP, ""));
  }

  void setApp(String name) {
    preferences.edit().putString(APP, name).apply();
  }

  /** The folder of a robot's stable storage. */
  Path robotFolder(String robot) {
    return folder.resolve("stable").resolve(robot);
  }

  /**
   * A new trace of that robot; with it, the last {@value #KEPT_TRACES} are kept.
   *
   * @throws IOException if it cannot be created
   */
  OutputStream newTrace(String robot) throws IOException {
    SortedMap<Integer, Path> there = traces(robot);
    int number = there.isEmpty() ? 1 : there.lastKey() + 1;
    for (Path old : there.headMap(number - KEPT_TRACES + 1).values()) {
      Files.delete(old);
    }
    Path folder = Files.createDirectories(traceFolder(robot));
    Path file = folder.resolve(robot + "." + number + TRACE);
    return new BufferedOutputStream(
        Files.newOutputStream(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE));
  }

  /**
   * Writes all traces of that robot as a zip, including the written part of the current trace.
   *
   * @return their number
   */
  int saveTraces(String robot, OutputStream to) throws IOException {
    Collection<Path> traces = traces(robot).values();
    try (ZipOutputStream zip = new ZipOutputStream(to)) {
      for (Path trace : traces) {
        zip.putNextEntry(new ZipEntry(String.valueOf(trace.getFileName())));
        Files.copy(trace, zip);
        zip.closeEntry();
      }
    }
    return traces.size();
  }

  private Path traceFolder(String robot) {
    return folder.resolve("traces").resolve(robot);
  }

  /** By their numbers, in the order in which they began. */
  private SortedMap<Integer, Path> traces(String robot) throws IOException {
    SortedMap<Integer, Path> found = new TreeMap<>();
    Pattern name = Pattern.compile(Pattern.quote(robot) + "\\.(\\d{1,9})" + Pattern.quote(TRACE));
    Path traces = traceFolder(robot);
    if (Files.exists(traces)) {
      try (DirectoryStream<Path> files = Files.newDirectoryStream(traces)) {
        for (Path file : files) {
          Matcher matcher = name.matcher(String.valueOf(file.getFileName()));
          if (matcher.matches()) {
            found.put(Integer.valueOf(matcher.group(1)), file);
          }
        }
      }
    }
    return found;
  }

  /**
   * Replaces a file by one that the user chose.
   *
   * @throws BadInput if it is too long or invalid; the old file is kept
   */
  void load(Item item, InputStream from) throws IOException {
    byte[] bytes = read(item, from);
    Path fresh = folder.resolve(item.file + ".fresh");
    Files.deleteIfExists(fresh);
    // The key file is readable only by its owner: KeyFile refuses others.
    try (OutputStream out =
        Channels.newOutputStream(
            Files.newByteChannel(
                fresh,
                EnumSet.of(StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE),
                PosixFilePermissions.asFileAttribute(
                    PosixFilePermissions.fromString("rw-------"))))) {
      out.write(bytes);
    }
    try {
      check(item, fresh);
    } catch (IOException e) {
      Files.delete(fresh);
      throw new BadInput("the file is not a " + item.name().toLowerCase(Locale.ROOT));
    } catch (BadInput e) {
      Files.delete(fresh);
      throw e;
    }
    Files.move(fresh, folder.resolve(item.file), StandardCopyOption.REPLACE_EXISTING);
  }

  /** The deployment that was loaded, with the chosen app if it has none; null without any. */
  @Nullable Deployment deployment() throws IOException {
    Path file = folder.resolve(Item.DEPLOYMENT.file);
    if (!Files.exists(file)) {
      return null;
    }
    Deployment deployment = parse(file);
    return deployment.app().isEmpty() ? deployment.withApp(app()) : deployment;
  }

  /**
   * This phone's task.
   *
   * @throws BadInput if it is incomplete or impossible; one line for people
   */
  Mission mission() throws IOException {
    Deployment deployment = deployment();
    if (deployment == null) {
      throw new BadInput("no deployment: load one first");
    }
    if (robotName().isEmpty()) {
      throw new BadInput(
          "this phone has no robot yet: choose one of " + deployment.robots().keySet());
    }
    if (deployment.app().isEmpty()) {
      throw new BadInput("this phone has no app yet: choose one of " + PhoneApps.names());
    }
    Path keyFile = folder.resolve(Item.KEY.file);
    PeerKeys keys =
        Files.exists(keyFile) ? deployment.keys(deployment.robot(robotName()), keyFile) : null;
    // A phone has one key file, so the feed's lines can only have the same key.
    boolean hasLinesKey =
        keys != null
            && deployment.positions() instanceof Positions.JsonFeed json
            && json.key() != null
            && json.key().equals(deployment.key());
    return Mission.of(deployment, robotName(), keys, hasLinesKey ? KeyFile.read(keyFile) : null);
  }

  private static void check(Item item, Path file) throws IOException {
    switch (item) {
      case DEPLOYMENT -> parse(file);
      case KEY -> readKey(file);
    }
  }

  /** Either kind of key: which one is right, the deployment says. */
  private static void readKey(Path file) throws IOException {
    if (Files.size(file) > KeyFile.MAX_BYTES) {
      RobotKey.read(file);
    } else {
      KeyFile.read(file);
    }
  }

  private static Deployment parse(Path file) throws IOException {
    String text = new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
    String name = Item.DEPLOYMENT.file;
    return DeploymentReader.read(name, text);
  }

  private static byte[] read(Item item, InputStream from) throws IOException {
    byte[] bytes = new byte[item.maxBytes];
    int length = 0;
    while (true) {
      if (length == bytes.length) {
        throw new BadInput("a file of over " + item.maxBytes + " bytes: expected a shorter one");
      }
      int count = from.read(bytes, length, bytes.length - length);
      if (count < 0) {
        return Arrays.copyOf(bytes, length);
      }
      length += count;
    }
  }
}
