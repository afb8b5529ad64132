// What every module shares. Each module applies its own plugins; this only sets them.
allprojects {
    group = "org.starl"
    version = "0.1.0-SNAPSHOT"
}

// The JDK that Gradle runs on compiles and tests, if it is new enough; else the release at JAVA_HOME, or
// the one the build is tested with, from wherever Gradle finds it.
val javaHomeRelease = providers.environmentVariable("JAVA_HOME")
    .map { home -> file("$home/release").readText().substringAfter("JAVA_VERSION=\"").takeWhile { it.isDigit() }.toInt() }
    .filter { it >= 21 }
val gradleIsOnOlderJava = !JavaVersion.current().isCompatibleWith(JavaVersion.VERSION_21)

subprojects {
    plugins.withId("java") {
        if (gradleIsOnOlderJava) {
            extensions.configure<JavaPluginExtension> {
                toolchain.languageVersion.set(JavaLanguageVersion.of(javaHomeRelease.getOrElse(25)))
            }
        }
    }

    plugins.withId("java") {
        extensions.configure<JavaPluginExtension> {
            withSourcesJar()
            withJavadocJar()
        }
    }

    // `publishToMavenLocal` does what `mvn install` does; the bill of materials has no jar.
    plugins.withId("maven-publish") {
        extensions.configure<org.gradle.api.publish.PublishingExtension> {
            publications.create("maven", org.gradle.api.publish.maven.MavenPublication::class.java) {
                from(components.getByName(if (plugins.hasPlugin("java-platform")) "javaPlatform" else "java"))
            }
        }
    }

    tasks.withType<org.gradle.api.tasks.javadoc.Javadoc>().configureEach {
        (options as org.gradle.external.javadoc.StandardJavadocDocletOptions).apply {
            addBooleanOption("Xdoclint:all,-missing", true)
            addBooleanOption("notimestamp", true)
            addBooleanOption("quiet", true)
            encoding = "UTF-8"
        }
    }

    tasks.withType<JavaCompile>().configureEach {
        options.encoding = "UTF-8"
        options.release.set(21)
        options.compilerArgs.addAll(listOf("-Xlint:all,-processing", "-Werror"))
    }

    tasks.withType<AbstractArchiveTask>().configureEach {
        isPreserveFileTimestamps = false
        isReproducibleFileOrder = true
    }

    tasks.withType<Test>().configureEach {
        // realtime: needs real time, sockets or other processes. long: takes more than some seconds; JUnit 4
        // has a category for it.
        useJUnitPlatform {
            if (!providers.gradleProperty("all").isPresent) {
                excludeTags("realtime", "long", "nightly", "org.starl.android.app.TakesLong")
            }
        }
        maxParallelForks = 2
        // The simulator's carriers need java.lang; libraries under test may load agents.
        jvmArgs("--add-opens", "java.base/java.lang=ALL-UNNAMED", "-XX:+EnableDynamicAgentLoading")
        // Most tests end before the second compiler pays; not those of modules with long runs.
        if (project.path !in setOf(":starl-lang", ":starl-primitives:states", ":starl-apps", ":starl-cli:bench")) {
            jvmArgs("-XX:TieredStopAtLevel=1")
        }
        systemProperty("java.awt.headless", "true")
        systemProperty("slf4j.internal.verbosity", "ERROR")
        systemProperty("jqwik.database", layout.buildDirectory.file("jqwik-database").get().asFile.path)
        systemProperty("jqwik.reporting.onlyfailures", "true")
    }
}
