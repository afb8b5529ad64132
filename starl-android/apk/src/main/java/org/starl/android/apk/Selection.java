package org.starl.android.apk;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;

/**
 * What a phone gets of a class path: StarL without simulator, desktop and command line; the apps that
 * files {@link #SERVICES} name; and of libraries the classes that these use.
 *
 * @param classes the class files, by name
 * @param own those of them that are in one folder or jar with an app that is not StarL's: a user's
 *     own code
 * @param apps names of the classes that make apps, for the APK's file {@link #SERVICES}
 */
record Selection(SortedMap<String, byte[]> classes, SortedSet<String> own, Set<String> apps) {

  /** Names the makers of apps, one in a line. */
  static final String SERVICES = "META-INF/services/org.starl.apps.AppFactory";

  /**
   * Of StarL: core, primitives without the search over their states, the real platform without its
   * serial ports, apps, the phone's app.
   */
  private static final Pattern OURS =
      Pattern.compile(
          "org/starl/([^/]+"
              + "|(body|comms|geometry|gvh|id|input|motion|platform|random|session|shape|spec|time|trace)/.+"
              + "|robot/(?!serial/).+|android/app/.+"
              + "|primitives/(?!exhaustive/|.+/(\\w+(States|Model)|SynodRobot|Mutex(Node|Oracle))[$.]).+"
              + "|apps/((AppFactory|Parameter|Request|RobotProgram)|(.+/)?(logic|robot|spec)/.+))\\.class");

  private static final String STARL = "org/starl/";
  private static final String ANDROID = "android-all-";

  /**
   * Selects from a class path.
   *
   * @throws ApkException if an app uses a class of StarL that a phone has not
   */
  static Selection of(String classPath) throws ApkException, IOException {
    try (ClassPath path = ClassPath.open(classPath, ANDROID)) {
      SortedSet<String> own = new TreeSet<>();
      Set<String> apps = apps(path, own);
      Closure closure = new Closure(path);
      for (String name : path.names()) {
        if (OURS.matcher(name).matches() && !name.endsWith("package-info.class")) {
          closure.need(name, "the APK");
        }
      }
      for (String app : apps) {
        closure.need(app.replace('.', '/') + ".class", SERVICES);
      }
      closure.follow();
      own.retainAll(closure.found.keySet());
      return new Selection(Collections.unmodifiableSortedMap(closure.found), own, apps);
    }
  }

  /**
   * StarL's tests check StarL's classes; this checks a user's own.
   *
   * @param platform the classes and members of Android 8
   * @throws ApkException if own classes use others
   */
  void refuseGaps(SortedMap<String, Links.Shape> platform) throws ApkException {
    SortedMap<String, byte[]> named = new TreeMap<>();
    classes.forEach((file, bytes) -> named.put(nameOf(file), bytes));
    SortedSet<String> looked = new TreeSet<>();
    own.forEach(file -> looked.add(nameOf(file)));
    SortedSet<String> missing = Links.missing(named, looked, platform);
    if (!missing.isEmpty()) {
      throw ApkException.badInput("Android 8 lacks: " + String.join(", ", missing));
    }
  }

  private static String nameOf(String file) {
    return file.substring(0, file.length() - ".class".length());
  }

  /** The makers of apps; adds the files beside those that are not StarL's. */
  private static Set<String> apps(ClassPath path, SortedSet<String> own) throws IOException {
    Set<String> apps = new LinkedHashSet<>();
    SortedMap<Integer, byte[]> files = path.all(SERVICES);
    for (int entry : files.keySet()) {
      String text = new String(files.get(entry), StandardCharsets.UTF_8);
      for (String line : text.split("\\R", -1)) {
        String app = line.replaceFirst("#.*", "").trim();
        if (!app.isEmpty()) {
          apps.add(app);
          if (!app.replace('.', '/').startsWith(STARL)) {
            own.addAll(path.names(entry));
          }
        }
      }
    }
    return apps;
  }

  /** Classes, and all that they use of the class path. */
  private static final class Closure {
    private final ClassPath path;
    private final SortedMap<String, byte[]> found = new TreeMap<>();
    private final SortedMap<String, String> neededBy = new TreeMap<>();
    private final Deque<String> open = new ArrayDeque<>();

    Closure(ClassPath path) {
      this.path = path;
    }

    void need(String name, String by) {
      if (neededBy.putIfAbsent(name, by) == null) {
        open.add(name);
      }
    }

    void follow() throws ApkException, IOException {
      for (String name = open.poll(); name != null; name = open.poll()) {
        byte[] bytes = path.bytes(name);
        if (bytes != null) {
          check(name);
          found.put(name, bytes);
          String from = name;
          References.of(
              bytes,
              new References.Listener() {
                @Override
                public void type(String type) {
                  need(type + ".class", from);
                }

                @Override
                public void member(String owner, String member) {
                  // Its owner is enough.
                }
              });
        } else if (SERVICES.equals(neededBy.get(name))) {
          throw ApkException.badInput(SERVICES + ": " + dotted(name) + ": expected a class");
        }
      }
    }

    private void check(String name) throws ApkException {
      if (name.startsWith(STARL) && !OURS.matcher(name).matches()) {
        throw ApkException.badInput(
            dotted(neededBy.getOrDefault(name, ""))
                + " uses "
                + dotted(name)
                + ", which no phone has; expected core, input and primitives only");
      }
    }

    private static String dotted(String name) {
      return name.replaceFirst("\\.class$", "").replace('/', '.');
    }
  }
}
