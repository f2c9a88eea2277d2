# The DXF files of this folder, by ezdxf 0.18.
import ezdxf, math
def pad(version):
    doc = ezdxf.new(version); msp = doc.modelspace()
    if version != 'R12': doc.header['$INSUNITS'] = 4
    for n in ('bottom','top','sides','face','flanks','loaded'): doc.layers.new(n)
    L = lambda a,b,l: msp.add_line(a,b,dxfattribs={'layer':l})
    L((-20,-15),(20,-15),'bottom'); L((20,0),(20,-15),'sides'); L((20,0),(-20,0),'top'); L((-20,0),(-20,-15),'sides')
    q = math.tan(math.radians(22.5))
    pts = [(-7,2,q),(-5,0,0),(5,0,q),(7,2,0)]
    if version == 'R12':
        p = msp.add_polyline2d([(x,y) for x,y,b in pts], dxfattribs={'layer':'face'})
        for v,(x,y,b) in zip(p.vertices, pts): v.dxf.bulge = b
    else:
        msp.add_lwpolyline(pts, format='xyb', dxfattribs={'layer':'face'})
    L((7,2),(7,10),'flanks'); L((7,10),(-7,10),'loaded'); L((-7,10),(-7,2),'flanks')
    msp.add_text('rounded pad', dxfattribs={'layer':'0'})
    doc.saveas(f'pad-{version.lower()}.dxf')
for v in ('R12', 'R2018'): pad(v)
# all other shapes: ring, slotted plate by arcs, ellipses, B-splines
doc = ezdxf.new('R2010'); msp = doc.modelspace(); doc.header['$INSUNITS'] = 6
msp.add_circle((0,0), 3, dxfattribs={'layer':'outer'}); msp.add_circle((0.5,0), 1, dxfattribs={'layer':'bore'})
msp.add_arc((10,0), 2, 90, 270, dxfattribs={'layer':'round'}); msp.add_arc((14,0), 2, 270, 90, dxfattribs={'layer':'round'})
msp.add_line((10,2),(14,2), dxfattribs={'layer':'long side'}); msp.add_line((10,-2),(14,-2), dxfattribs={'layer':'long side'})
msp.add_ellipse((0,10), (4,1,0), 0.5, dxfattribs={'layer':'oval'})
msp.add_ellipse((0,10), (1,0,0), 0.4, dxfattribs={'layer':'eye'})
msp.add_ellipse((12,10), (3,0,0), 0.5, 0, math.pi, dxfattribs={'layer':'dome'}); msp.add_line((9,10),(15,10), dxfattribs={'layer':'base'})
s = msp.add_spline(degree=3, dxfattribs={'layer':'wave'}); s.set_open_uniform([(20,10),(22,13),(24,7),(26,12),(28,10)], 3)
msp.add_line((20,10),(20,5)); msp.add_line((20,5),(28,5)); msp.add_line((28,5),(28,10))
s = msp.add_spline(degree=3, dxfattribs={'layer':'blob'}); s.set_closed([(22,0,0),(25,-1,0),(27,1,0),(25,3,0),(22,2,0)], 3)
r = msp.add_spline(degree=2, dxfattribs={'layer':'rational quarter'}); r.set_open_rational([(34,0),(34,4),(30,4)], [1,math.sqrt(.5),1], 2)
msp.add_line((34,0),(30,0)); msp.add_line((30,0),(30,4))
doc.saveas('shapes.dxf')
# a block put in four ways
doc = ezdxf.new('R12'); msp = doc.modelspace()
b = doc.blocks.new(name='plate', base_point=(1, 1))
b.add_line((0, 0), (3, 0)); b.add_line((3, 0), (3, 2)); b.add_line((3, 2), (2, 2)); b.add_line((1, 2), (0, 2)); b.add_line((0, 2), (0, 0))
b.add_arc((1.5, 2), 0.5, 180, 360, dxfattribs={'layer': 'notch'})
msp.add_blockref('plate', (0, 0), dxfattribs={'layer': 'first'})
msp.add_blockref('plate', (10, 0), dxfattribs={'layer': 'second', 'rotation': 30, 'xscale': 2, 'yscale': 2})
msp.add_blockref('plate', (0, 10), dxfattribs={'layer': 'third', 'xscale': -1})
msp.add_blockref('plate', (10, 20), dxfattribs={'layer': 'fourth', 'rotation': 90, 'column_count': 2, 'column_spacing': 5})
doc.saveas('blocks.dxf')
# what is not to be seen: layers that are off, frozen, not plotted; on paper; endless lines
doc = ezdxf.new('R2010'); msp = doc.modelspace(); doc.header['$INSUNITS'] = 4
for n in ('plate', 'off', 'frozen', 'helper'): doc.layers.new(n)
doc.layers.get('off').off(); doc.layers.get('frozen').freeze(); doc.layers.get('helper').dxf.plot = 0
msp.add_lwpolyline([(0,0),(40,0),(40,20),(0,20)], close=True, dxfattribs={'layer':'PLATE'})
msp.add_circle((8,10), 3, dxfattribs={'layer':'off'}); msp.add_circle((20,10), 3, dxfattribs={'layer':'frozen'})
msp.add_line((0,10),(40,10), dxfattribs={'layer':'helper'})
msp.add_xline((0,10),(1,0)); msp.add_ray((0,0),(1,1)); msp.add_circle((32,10), 2, dxfattribs={'layer':'plate'})
b = doc.blocks.new('bolt'); b.add_circle((0,0), 1); b.add_circle((0,0), 1.5, dxfattribs={'layer':'off'})
msp.add_blockref('BOLT', (8,10), dxfattribs={'layer':'plate'}); msp.add_blockref('bolt', (20,10), dxfattribs={'layer':'frozen'})
doc.layout('Layout1').add_circle((8,10), 3)
doc.saveas('layers.dxf')
# a block of every curve, stretched: a plate with round ends, a bulge, an ellipse, B-splines and a spline by fit points
doc = ezdxf.new('R2010'); msp = doc.modelspace()
b = doc.blocks.new('part', base_point=(1, 0))
b.add_line((0,0),(6,0)); b.add_arc((6,1), 1, 270, 90); b.add_line((6,2),(0,2)); b.add_arc((0,1), 1, 90, 270)
b.add_lwpolyline([(0,.5,1),(0,1.5,1)], format='xyb', close=True)
b.add_ellipse((3,1), (.5,.5,0), .5)
b.add_open_spline([(7.5,0),(7.5,3),(9,3),(9,0)]); b.add_line((7.5,0),(9,0))
b.add_spline([(10,0),(11,1),(12,.5),(13,0)]); b.add_line((10,0),(13,0))
for x, y, turn, at in ((1,1,0,(0,0)), (2,.5,0,(0,10)), (-1,3,30,(40,0)), (.25,-1,90,(60,0))):
    msp.add_blockref('part', at, dxfattribs={'xscale':x, 'yscale':y, 'rotation':turn})
doc.saveas('stretched.dxf')
# splines with control points on each other, and angles that are rounded to few digits
doc = ezdxf.new('R2000'); msp = doc.modelspace()
def bezier(points, layer):
    s = msp.add_spline(degree=3, dxfattribs={'layer':layer}); s.control_points = points
    s.knots = [0]*4 + [float(k) for k in range(1, (len(points) - 1)//3) for _ in range(3)] + [float((len(points) - 1)//3)]*4
msp.add_lwpolyline([(0,5),(0,0),(10,0),(10,5)], dxfattribs={'layer':'base'})
bezier([(10,5),(10,5),(2,11),(0,5)], 'crown')
msp.add_lwpolyline([(20,5),(20,0),(30,0),(30,5)], dxfattribs={'layer':'base'})
bezier([(30,5),(30,8),(25,9),(25,9),(25,9),(22,9),(20,5)], 'tip')
msp.add_ellipse((45,5), (8,0,0), .5, 0, 6.2831854, dxfattribs={'layer':'oval'}); msp.add_ellipse((45,5), (2,0,0), .5, 0, 6.28318, dxfattribs={'layer':'eye'})
msp.add_arc((65,5), 5, 0, 359.9999, dxfattribs={'layer':'ring'}); msp.add_arc((65,5), 2, 90, 450.0001, dxfattribs={'layer':'ring'})
doc.saveas('rounded.dxf')
# a pin that is larger than its hole, as a press fit is drawn, and outlines that are alike but for their layers
doc = ezdxf.new('R2000'); msp = doc.modelspace(); doc.header['$INSUNITS'] = 4
msp.add_circle((0,0), 20, dxfattribs={'layer':'rim'}); msp.add_circle((0,0), 10, dxfattribs={'layer':'hole'})
msp.add_circle((0,0), 10.01, dxfattribs={'layer':'pin'}); msp.add_circle((0,0), 5, dxfattribs={'layer':'bore'})
doc.saveas('press-fit.dxf')
