plugins {
    `java-library`
    id("maven-publish")
}

description = "The app for phones: an activity, and a service that runs one robot"

dependencies {
    implementation(project(":starl-core"))
    implementation(project(":starl-core-input"))
    implementation(project(":starl-primitives"))
    implementation(project(":starl-android-robot"))
    implementation(project(":starl-apps"))
    // Android itself, for compiling and for Robolectric; a phone has its own.
    compileOnly(libs.android.all)
    // Merges the traces that the phones of a test leave.
    testImplementation(project(":starl-cli"))
    testImplementation(libs.robolectric)
    // Robolectric's tests are JUnit 4's.
    testImplementation(libs.junit.vintage.engine)
    testImplementation(libs.archunit)
    implementation(libs.jspecify)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}

// What is compiled with is tested on.
configurations.named("testImplementation") {
    extendsFrom(configurations.named("compileOnly").get())
}

configurations.configureEach {
    // Draws as a phone does, in 160 MB; no test looks at pixels.
    exclude(mapOf("group" to "org.robolectric", "module" to "nativeruntime-dist-compat"))
}

// Android's own classes bear annotations that no jar has.
tasks.withType<JavaCompile>().configureEach {
    options.compilerArgs.add("-Xlint:-classfile,-path")
}

tasks.withType<Test>().configureEach {
    // Robolectric makes an Android of the one on the class path, and reaches into the JDK for that.
    systemProperty("robolectric.usePreinstrumentedJars", "false")
    jvmArgs("--add-exports", "java.base/jdk.internal.access=ALL-UNNAMED", "--enable-native-access=ALL-UNNAMED")
    // It needs classes of androidx that come as aars: zips around a jar.
    classpath += files(configurations.named("testRuntimeClasspath").map { path ->
        path.filter { it.name.endsWith(".aar") }.map { aar -> zipTree(aar).matching { include("classes.jar") } }
    })
}
