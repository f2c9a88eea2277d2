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
